// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// TACTOOTH_ASSERT(condition) states what the program itself guarantees: a precondition of a call or an invariant of a
// structure. Bad input from outside is an Expected, never an assert. The build option TACTOOTH_ASSERTS switches the
// checks on. They are in the builds for tests, and not in the release build, whose 1 kHz step has none. The condition
// is compiled in both, so that it stays valid code.

namespace tactooth {

/// An assert whose condition was false.
struct AssertFailure {
    const char* condition;  ///< the text of the condition
    const char* file;
    int line;
    const char* function;
};

/// Called on a failed assert. If it returns, the program continues behind the assert; the handler of a test may throw.
using AssertHandler = void (*)(const AssertFailure& failure);

/// Replaces the handler of the whole program and returns the one before. nullptr: the default, which writes one line to
/// stderr and aborts. Any thread.
AssertHandler setAssertHandler(AssertHandler handler);

/// Calls the handler; for the macro.
void assertFailed(const AssertFailure& failure);

}  // namespace tactooth

#if defined(TACTOOTH_ASSERTS)
#define TACTOOTH_ASSERT(...) \
    ((__VA_ARGS__) ? (void)0 \
                   : ::tactooth::assertFailed({#__VA_ARGS__, __FILE__, __LINE__, static_cast<const char*>(__func__)}))
#else
#define TACTOOTH_ASSERT(...) ((void)sizeof((__VA_ARGS__) ? 1 : 0))
#endif
