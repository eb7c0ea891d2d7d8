// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "geometry/util/assert.h"

namespace tactooth::test {

/// Thrown by the handler that EXPECT_ASSERT installs.
struct AssertFired {
    std::string condition;
};

/// While an object lives, a failed assert throws AssertFired instead of aborting.
class ThrowingAsserts {
public:
    ThrowingAsserts()
        : before_(setAssertHandler([](const AssertFailure& failure) { throw AssertFired{failure.condition}; })) {}
    ~ThrowingAsserts() { setAssertHandler(before_); }
    ThrowingAsserts(const ThrowingAsserts&) = delete;
    ThrowingAsserts& operator=(const ThrowingAsserts&) = delete;

private:
    AssertHandler before_;
};

}  // namespace tactooth::test

/// Expects that the statement fires an assert. Without asserts the statement would do what it must not: the test is
/// skipped.
#if defined(TACTOOTH_ASSERTS)
#define EXPECT_ASSERT(statement)                                                                  \
    do {                                                                                          \
        const ::tactooth::test::ThrowingAsserts throwingAsserts;                                  \
        EXPECT_THROW(statement, ::tactooth::test::AssertFired) << "no assert fired: " #statement; \
    } while (false)
#else
#define EXPECT_ASSERT(statement) GTEST_SKIP() << "built without asserts"
#endif
