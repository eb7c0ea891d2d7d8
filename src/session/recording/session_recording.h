// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "journal/file/attachment_reader.h"
#include "journal/file/journal_reader.h"
#include "session/kernel/session_event.h"
#include "session/recording/mirror_sight.h"
#include "session/recording/session_text.h"
#include "session/simulation/session_work.h"

namespace tactooth {

/// A recorded session in a file. It reads the blocks one after the other, and keeps none in memory.
class SessionRecording {
public:
    /// Fails with one sentence if the file cannot be read or is no recording. A file that was cut off opens up to its
    /// last whole block.
    [[nodiscard]] static Expected<SessionRecording> open(const std::filesystem::path& path);

    [[nodiscard]] const RecordingFacts& facts() const { return facts_; }
    [[nodiscard]] const JournalReader& journal() const { return journal_; }
    /// Ticks of all burs together.
    [[nodiscard]] std::uint64_t ticks() const;

    /// Length of the session, s. Reads all events. Fails with one sentence if a block is damaged.
    [[nodiscard]] Expected<double> seconds() const;

    /// The tooth before the first event, with all around it. Fails with one sentence if it is damaged.
    [[nodiscard]] Expected<std::shared_ptr<CutModel>> makeModel() const;

    /// What somebody was doing, as the program described it last; nothing if it did not, or if that is damaged. Time
    /// and events are those of before the first event.
    [[nodiscard]] std::optional<SessionWork> work() const;
    /// Whether something was cut, put back or undone. Fails with one sentence if a block is damaged.
    [[nodiscard]] Expected<bool> hasChanges() const;

    /// Calls `visit` with each event in turn, until it returns false. Fails with one sentence if a block is damaged.
    [[nodiscard]] Expected<void> forEach(const std::function<bool(const SessionEvent&)>& visit) const;

    /// How the mirror was held, in the order of the ticks; empty: it was not recorded. Fails with one sentence if a
    /// block is damaged.
    [[nodiscard]] Expected<std::vector<MirrorMoment>> mirror() const;

    /// The end of a recording that was finished; without hash and gap if it was cut off.
    [[nodiscard]] Expected<RecordedEnd> end() const;

private:
    SessionRecording(JournalReader journal, RecordingFacts facts);
    [[nodiscard]] Expected<std::shared_ptr<CutModel>> makeTouched() const;
    [[nodiscard]] Expected<BeginEvent> beginEvent(const std::string& setup) const;

    JournalReader journal_;
    RecordingFacts facts_;
};

}  // namespace tactooth
