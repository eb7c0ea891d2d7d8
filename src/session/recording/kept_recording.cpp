// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/recording/kept_recording.h"

#include <string>
#include <utility>

namespace tactooth {

namespace {

/// For the name of the file.
std::string titleOfPart(std::string title, const RecordingPart& part) {
    if (part.number > 1) title += (title.empty() ? "part " : " part ") + std::to_string(part.number);
    return title;
}

}  // namespace

KeptRecording::KeptRecording(RecordingFolder folder, std::shared_ptr<const CutModel> tooth, std::string title,
                             const RecordingPart& part)
    : folder_(std::move(folder)),
      tooth_(std::move(tooth)),
      title_(titleOfPart(std::move(title), part)),
      began_(folder_.now()) {}

KeptRecording::~KeptRecording() {
    if (recorder_ == nullptr) return;
    const bool isKept = isWorthKeeping();
    recorder_.reset();
    if (!isKept) folder_.discard(file_);
}

/// A window that stood still for seconds may have missed the touch.
bool KeptRecording::isWorthKeeping() const { return isTouched_ || recorder_->hasChanges(); }

Expected<std::shared_ptr<KeptRecording>> KeptRecording::begin(const RecordingFolder& folder,
                                                              std::shared_ptr<const CutModel> tooth,
                                                              const std::string& title, const std::string& work,
                                                              std::shared_ptr<const SigningKey> seal,
                                                              const RecordingPart& part,
                                                              const std::filesystem::path& before) {
    folder.tidy();
    Expected<std::filesystem::path> file = folder.liveName(before);
    if (!file) return Unexpected{file.error()};
    const bool isSealed = seal != nullptr;
    auto recorder = SessionRecorder::create(*file, *tooth, title, std::move(seal), part);
    if (!recorder) return Unexpected{recorder.error()};
    std::shared_ptr<KeptRecording> made(new KeptRecording(folder, std::move(tooth), title, part));
    made->file_ = std::move(*file);
    made->isSealed_ = isSealed;
    made->recorder_ = std::move(*recorder);
    made->recorder_->describe(work);
    return made;
}

Expected<void> KeptRecording::finish() {
    const Expected<void> closed = recorder_->close(recorder_->isWhole() ? tooth_->hash() : 0);
    const bool isKept = isWorthKeeping();
    recorder_.reset();
    if (!isKept) {
        folder_.discard(file_);
        file_.clear();
        return {};
    }
    const auto kept = folder_.keep(file_, began_, title_);
    if (kept) file_ = *kept;
    folder_.tidy();
    if (!closed) return closed;
    if (!kept) return Unexpected{kept.error()};
    return {};
}

}  // namespace tactooth
