// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/util/assert.h"

#include <string>

#include "geometry/util/expected.h"
#include "support/expect_assert.h"

namespace tactooth::test {
namespace {

TEST(Assert, PassesWhereTheConditionHolds) {
    const ThrowingAsserts asserts;
    EXPECT_NO_THROW(TACTOOTH_ASSERT(1 + 1 == 2));
}

#if defined(TACTOOTH_ASSERTS)

TEST(Assert, NamesConditionFileLineAndFunction) {
    static AssertFailure seen;
    const AssertHandler before = setAssertHandler([](const AssertFailure& failure) { seen = failure; });
    const int line = __LINE__ + 1;
    TACTOOTH_ASSERT(2 < 1);
    setAssertHandler(before);
    EXPECT_STREQ(seen.condition, "2 < 1");
    EXPECT_EQ(seen.line, line);
    EXPECT_NE(std::string(seen.file).find("assert_test.cpp"), std::string::npos);
    EXPECT_STREQ(seen.function, "TestBody");
}

TEST(Assert, TakesConditionsWithCommas) { EXPECT_ASSERT(TACTOOTH_ASSERT(std::pair<int, int>{1, 2}.first == 2)); }

TEST(Assert, FiresForTheValueOfAFailure) {
    Expected<int> failed = unexpected(Message::verbatim("a reason"));
    EXPECT_ASSERT(static_cast<void>(failed.value()));
    Expected<int> fine = 1;
    EXPECT_ASSERT(static_cast<void>(fine.error()));
}

TEST(AssertDeathTest, AbortsByDefault) {
    EXPECT_DEATH(TACTOOTH_ASSERT(1 > 2), "assert_test.cpp:.*TestBody: assertion failed: 1 > 2");
}

#else

TEST(Assert, IsNotEvaluatedInTheReleaseBuild) {
    int calls = 0;
    TACTOOTH_ASSERT(++calls > 0);
    EXPECT_EQ(calls, 0);
}

#endif

}  // namespace
}  // namespace tactooth::test
