// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "app/common/termination.h"
#include "geometry/files/file_transaction.h"
#include "journal/file/journal_file.h"
#include "session/kernel/stepwise_session.h"
#include "session/recording/session_recorder.h"

namespace tactooth {

/// The recording that --record asks for. A run that is recorded ends in order when a signal would end the program, so
/// that the recording gets its end, too.
class RunRecording {
public:
    /// Opens the file; an empty path means no recording. Call it before the inputs are read, so that an obstacle is
    /// reported at once. `seals`: it is signed with the key of this station. `others`: the other files of the run, or
    /// null. Fails with one sentence, also if something has the name that is neither a recording nor an empty file.
    [[nodiscard]] Expected<void> open(const std::filesystem::path& path, bool seals,
                                      const FileTransaction* others = nullptr);
    /// `model`: the tooth before the run. Without a file nothing happens.
    [[nodiscard]] Expected<void> begin(const CutModel& model, const std::string& title);

    /// Null without a recording.
    [[nodiscard]] SessionRecorder* recorder() { return recorder_.get(); }
    /// The key that signs it; null without `seals`.
    [[nodiscard]] const std::shared_ptr<const SigningKey>& seal() const { return seal_; }
    /// Empty without a recording.
    [[nodiscard]] StepwiseSession::EventSink sink();
    /// Asks for the end once a signal has come.
    [[nodiscard]] std::stop_token stop() const { return stop_.get_token(); }

    /// `toothHash`: of the tooth now. Without a recording nothing happens.
    [[nodiscard]] Expected<void> close(std::uint64_t toothHash);

private:
    std::filesystem::path path_;
    std::shared_ptr<const SigningKey> seal_;
    std::unique_ptr<JournalFile> file_;
    std::unique_ptr<SessionRecorder> recorder_;
    std::stop_source stop_;
    std::optional<GracefulShutdown> shutdown_;  // last: it uses stop_
};

}  // namespace tactooth
