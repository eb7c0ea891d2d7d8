// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>

#include "session/recording/recording_folder.h"
#include "session/recording/session_recorder.h"

namespace tactooth {

/// The recording of a session in the user's folder, from its beginning to its final name. One thread at a time.
class KeptRecording {
public:
    /// Makes room in the folder and begins with the tooth as it is now; nothing was cut since it was opened. It writes
    /// the tooth, which takes a moment. `work`: see workText. `seal`: signs it; null: nobody does. `before`: the
    /// recording of the part before, whose name is not taken again even if the file is gone. Fails with one sentence if
    /// the folder cannot be used.
    [[nodiscard]] static Expected<std::shared_ptr<KeptRecording>> begin(
        const RecordingFolder& folder, std::shared_ptr<const CutModel> tooth, const std::string& title,
        const std::string& work, std::shared_ptr<const SigningKey> seal = {}, const RecordingPart& part = firstPart(),
        const std::filesystem::path& before = {});

    /// Without `finish` the file stays as after a crash, unless nothing was touched.
    ~KeptRecording();
    KeptRecording(const KeptRecording&) = delete;
    KeptRecording& operator=(const KeptRecording&) = delete;

    [[nodiscard]] SessionRecorder& recorder() { return *recorder_; }
    [[nodiscard]] const SessionRecorder& recorder() const { return *recorder_; }
    /// Of which tooth.
    [[nodiscard]] const CutModel* tooth() const { return tooth_.get(); }
    /// Where it is now: `finish` gives it its final name.
    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    [[nodiscard]] bool isSealed() const { return isSealed_; }
    /// The instrument has touched something: the recording is worth keeping. One that holds a cut is, without it.
    void noteTouch() { isTouched_ = true; }

    /// Ends it and gives the file its final name; removes it if nothing was touched. No thread works on the tooth any
    /// more, unless the recording has stopped before. Waits for the disk. Fails with one sentence if the recording has
    /// stopped before; what was recorded is kept. Call it once, last.
    [[nodiscard]] Expected<void> finish();

private:
    KeptRecording(RecordingFolder folder, std::shared_ptr<const CutModel> tooth, std::string title,
                  const RecordingPart& part);
    [[nodiscard]] bool isWorthKeeping() const;

    RecordingFolder folder_;
    std::shared_ptr<const CutModel> tooth_;
    std::string title_;
    std::chrono::system_clock::time_point began_;
    std::filesystem::path file_;
    std::unique_ptr<SessionRecorder> recorder_;
    bool isTouched_ = false;
    bool isSealed_ = false;
};

}  // namespace tactooth
