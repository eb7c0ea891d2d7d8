// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <thread>

#include "app/common/replay_scene.h"
#include "session/model/instrument_set.h"
#include "session/recording/session_recording.h"
#include "session/track/session_track.h"
#include "session/track/tooth_follower.h"

namespace tactooth {

/// An open recording: a thread simulates it once and fills its track, while the picture shows what is there already.
class ReplaySource {
public:
    /// Reads the recording and begins to simulate it. It takes a second: run it in a Task. Fails with one sentence if
    /// the file is none, or damaged.
    [[nodiscard]] static Expected<std::shared_ptr<ReplaySource>> open(const std::filesystem::path& file);
    ReplaySource(const ReplaySource&) = delete;
    ReplaySource& operator=(const ReplaySource&) = delete;

    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    [[nodiscard]] const RecordingFacts& facts() const { return recording_.facts(); }
    [[nodiscard]] const std::shared_ptr<SessionTrack>& track() const { return track_; }
    /// The tooth before the first event.
    [[nodiscard]] const std::shared_ptr<CutModel>& uncut() const { return uncut_; }
    /// The materials as they were when the bur of this moment began to work.
    [[nodiscard]] MaterialTable materialsAt(std::uint64_t moment) const;

    /// Tooth, instrument and mouth mirror at a moment that the track has. The tooth follows as soon as it is there. The
    /// drive of the recording chooses from `handpieces`. One thread.
    [[nodiscard]] SceneContents contentsAt(std::uint64_t moment, const HandpieceMeshes& handpieces);
    /// Whether the tooth of the last call is that of its moment.
    [[nodiscard]] bool isToothThere() const { return follower_.isThere(); }

private:
    ReplaySource(std::filesystem::path file, SessionRecording recording, std::shared_ptr<SessionTrack> track,
                 std::shared_ptr<CutModel> model);
    [[nodiscard]] const ReplayBur& shownBur(const std::shared_ptr<const TrackBur>& bur);

    std::filesystem::path file_;
    SessionRecording recording_;
    std::shared_ptr<SessionTrack> track_;
    std::shared_ptr<CutModel> uncut_;
    std::vector<ShownBody> around_;
    std::map<std::shared_ptr<const TrackBur>, ReplayBur> burs_;
    ReplayMirror mirror_;
    ToothFollower follower_;
    std::jthread maker_;  // last: it uses the members above
};

}  // namespace tactooth
