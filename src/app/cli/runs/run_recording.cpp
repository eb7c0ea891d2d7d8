// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/runs/run_recording.h"

#include <utility>

#include "geometry/files/file_bytes.h"
#include "session/recording/station_key.h"

namespace tactooth {

Expected<void> RunRecording::open(const std::filesystem::path& path, bool seals, const FileTransaction* others) {
    if (seals) {
        Expected<StationKey> station = openStationKey();
        if (!station) return Unexpected{station.error()};
        seal_ = std::move(station->key);
    }
    if (path.empty()) return {};
    if (others != nullptr) {
        if (auto free = others->checkFree(path); !free) return free;
    }
    Expected<std::unique_ptr<JournalFile>> file = createJournalFile(path, ExistingFile::ReplacedIfOurOwn);
    if (!file) return Unexpected{file.error()};
    path_ = path;
    file_ = std::move(*file);
    shutdown_.emplace([this] { stop_.request_stop(); });
    return {};
}

Expected<void> RunRecording::begin(const CutModel& model, const std::string& title) {
    if (file_ == nullptr) return {};
    auto recorder = SessionRecorder::start(std::move(file_), displayName(path_), model, title, seal_);
    if (!recorder) return Unexpected{recorder.error()};
    recorder_ = std::move(*recorder);
    return {};
}

StepwiseSession::EventSink RunRecording::sink() {
    if (recorder_ == nullptr) return {};
    return [this](const SessionEvent& event) { recorder_->append(event); };
}

Expected<void> RunRecording::close(std::uint64_t toothHash) {
    if (recorder_ == nullptr) return {};
    return std::exchange(recorder_, nullptr)->close(toothHash);
}

}  // namespace tactooth
