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
///   sentence and end the program by that signal, or let it end in order: see OrderlyEnd;
/// * an exception that nobody catches removes all unfinished files, is told in one sentence and ends the program with
///   exit code 2.
void prepareEnding();

/// While it lives, a signal that ends the program calls `asked` instead, on a thread of its own; whoever made this then
/// ends in order, and endAsAsked comes last. A second signal, or none of that within kOrderlySeconds, ends it at once.
class OrderlyEnd {
public:
    explicit OrderlyEnd(std::function<void()> asked);
    ~OrderlyEnd();
    OrderlyEnd(const OrderlyEnd&) = delete;
    OrderlyEnd& operator=(const OrderlyEnd&) = delete;
};
inline constexpr double kOrderlySeconds = 8;

/// The last call of the program: `exitCode`, or the end by the signal that has asked for an orderly one.
[[nodiscard]] int endAsAsked(int exitCode);

}  // namespace tactooth
