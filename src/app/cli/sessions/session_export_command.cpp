// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/sessions/session_export_command.h"

#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "geometry/files/file_bytes.h"
#include "geometry/files/file_transaction.h"
#include "session/export/session_mcap.h"
#include "session/io/tick_csv.h"
#include "session/recording/session_replay.h"

namespace tactooth {
namespace {

int exitCodeFor(const std::optional<double>& differsAt) {
    if (!differsAt) return kExitOk;
    print("The replay differs from the recording from {:.1f} s on; the file ends there.\n", *differsAt);
    return kExitNegative;
}

}  // namespace

int runSessionExportCsv(const SessionExportOptions& options) {
    FileTransaction files;
    files.reads(options.session);
    if (const auto opened = files.open(options.out); !opened) return reportError(opened.error());
    const Expected<SessionRecording> recording = SessionRecording::open(options.session);
    if (!recording) return reportError(recording.error());
    Expected<SessionReplay> replay = SessionReplay::start(*recording);
    if (!replay) return reportError(replay.error());
    auto file = TickCsv::create(options.out);
    if (!file) return reportError(file.error());
    const auto row = [&](double time, const Tick& tick) { file->write(time, tick); };
    if (const auto played = replay->playUntil({}, row); !played) return reportError(played.error());
    if (const auto done = file->commit(); !done) return reportError(done.error());
    if (const auto done = files.commit(); !done) return reportError(done.error());
    print("{} ticks written to {}\n", replay->ticks(), displayName(options.out));
    return exitCodeFor(replay->differsAt());
}

int runSessionExportMcap(const SessionExportOptions& options) {
    FileTransaction files;
    files.reads(options.session);
    if (const auto opened = files.open(options.out); !opened) return reportError(opened.error());
    const Expected<SessionRecording> recording = SessionRecording::open(options.session);
    if (!recording) return reportError(recording.error());
    const Expected<McapExport> done = exportMcap(*recording, options.out, options.rateHz);
    if (!done) return reportError(done.error());
    if (const auto committed = files.commit(); !committed) return reportError(committed.error());
    print("{} messages of {:.1f} s written to {}\n", done->messages, done->seconds, displayName(options.out));
    return exitCodeFor(done->differsAt);
}

}  // namespace tactooth
