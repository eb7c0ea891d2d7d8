// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace tactooth {

/// To be called first of all, while the program has one thread. Afterwards:
///
/// * files 0, 1 and 2 are open (on /dev/null where they were closed), so that none of the program's files is one of
/// them;
/// * SIGPIPE and SIGXFSZ do nothing: the write that raised them fails and is told as any other;
/// * SIGINT, SIGTERM and SIGHUP (not where it was ignored, as by nohup) remove all unfinished files, say so in one
///   sentence and end the program by that signal, or let it end in order: see GracefulShutdown;
/// * an exception that nobody catches removes all unfinished files, is told in one sentence and ends the program with
///   exit code 2.
void installTerminationHandlers();

/// While it lives, a signal that ends the program calls `asked` instead, on a thread of its own; whoever made this then
/// ends in order, and exitAsRequested comes last. A second signal, or none of that within kShutdownGrace, ends it at
/// once.
class GracefulShutdown {
public:
    explicit GracefulShutdown(std::function<void()> asked);
    ~GracefulShutdown();
    GracefulShutdown(const GracefulShutdown&) = delete;
    GracefulShutdown& operator=(const GracefulShutdown&) = delete;
};
inline constexpr double kShutdownGrace = 8;

/// The last call of the program: `exitCode`, or the end by the signal that has asked for an orderly one.
[[nodiscard]] int exitAsRequested(int exitCode);

}  // namespace tactooth
