// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/sessions/session_trim_command.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/cli/sessions/messages.h"
#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "geometry/files/file_bytes.h"
#include "geometry/files/file_transaction.h"
#include "geometry/util/number_text.h"
#include "journal/file/journal_trim.h"
#include "session/recording/session_recording.h"

namespace tactooth {
namespace {

/// The ticks between two times, and the length of the whole session.
struct TicksOfTimes {
    TickRange range;
    double seconds = 0;
};

Expected<TicksOfTimes> ticksOf(const SessionRecording& recording, double from, std::optional<double> to) {
    TicksOfTimes found;
    std::uint64_t ticks = 0;
    const auto read = recording.forEach([&](const SessionEvent& event) {
        const std::optional<double> elapsed = secondsOf(event);
        if (!elapsed) return true;
        found.seconds += *elapsed;
        ++ticks;
        if (found.seconds <= from) found.range.begin = ticks;
        if (!to || found.seconds <= *to) found.range.end = ticks;
        return true;
    });
    if (!read) return Unexpected{read.error()};
    return found;
}

}  // namespace

int runSessionTrim(const SessionTrimOptions& options) {
    if (options.to && *options.to <= options.from) {
        return reportError({msg::kTrimBackwards, numberText(options.from), numberText(*options.to)});
    }
    FileTransaction files;
    files.reads(options.session);
    if (const auto opened = files.open(options.out); !opened) return reportError(opened.error());
    const Expected<SessionRecording> recording = SessionRecording::open(options.session);
    if (!recording) return reportError(recording.error());
    const Expected<TicksOfTimes> asked = ticksOf(*recording, options.from, options.to);
    if (!asked) return reportError(asked.error());
    const std::string& name = recording->journal().name();
    if (options.from > 0 && asked->seconds <= options.from) {
        return reportError({msg::kTrimBehindEnd, name, fmt::format("{:.1f}", asked->seconds)});
    }
    const std::uint64_t begin = options.from > 0 ? asked->range.begin : 0;
    if (options.from > 0 && recording->journal().keyframeBefore(begin) == nullptr) {
        return reportError({msg::kTrimNoKeyframe, name, numberText(options.from)});
    }
    const std::optional<std::string> header = unsealedHeader(recording->journal().headerJson());
    const Expected<JournalTrim> trim =
        trimJournal(options.session, options.out, begin, std::max(begin + 1, asked->range.end), header);
    if (!trim) return reportError(trim.error());
    if (const auto done = files.commit(); !done) return reportError(done.error());
    print("{}: {} ticks in {} blocks\n", displayName(options.out), trim->ticks.end - trim->ticks.begin, trim->blocks);
    if (header) print("The copy is not sealed: keep the recording, too.\n");
    return kExitOk;
}

}  // namespace tactooth
