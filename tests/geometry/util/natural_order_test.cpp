// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/util/natural_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace tactooth {
namespace {

TEST(NaturalOrder, TakesNumbersByTheirValue) {
    std::vector<std::string> names = {"b1", "a10b", "a9", "a010a", "a", "10", "9"};
    std::ranges::sort(names, isNaturallyLess);
    EXPECT_EQ(names, (std::vector<std::string>{"9", "10", "a", "a9", "a010a", "a10b", "b1"}));
}

}  // namespace
}  // namespace tactooth
