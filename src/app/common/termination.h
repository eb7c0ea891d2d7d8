// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace tactooth {

/// Call it first of all, while the program has one thread. Afterwards:
///
/// * files 0, 1 and 2 are open (on /dev/null where they were closed), so that none of the program's files is one of
///   them;
/// * SIGPIPE and SIGXFSZ do nothing: the write that raised them fails and is reported like any other failed write;
/// * SIGINT, SIGTERM and SIGHUP (unless it was ignored, as by nohup) remove all unfinished files and report this in one
///   sentence; then they end the program by that signal. With a GracefulShutdown they start that instead;
/// * an uncaught exception removes all unfinished files, is reported in one sentence and ends the program with exit
///   code 2.
void installTerminationHandlers();

/// During its lifetime, a signal that would end the program calls `asked` instead, on a separate thread. The owner then
/// shuts down in order and calls exitAsRequested last. A second signal, or no shutdown within kShutdownGrace, ends the
/// program at once.
class GracefulShutdown {
public:
    explicit GracefulShutdown(std::function<void()> asked);
    ~GracefulShutdown();
    GracefulShutdown(const GracefulShutdown&) = delete;
    GracefulShutdown& operator=(const GracefulShutdown&) = delete;
};
inline constexpr double kShutdownGrace = 8;

/// The last call of the program: exits with `exitCode`, or by the signal that asked for the graceful shutdown.
[[nodiscard]] int exitAsRequested(int exitCode);

}  // namespace tactooth
