// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "instruments/permanent_teeth.h"

namespace tactooth {
namespace {

TEST(TwentyMouths, HaveSoundNestedLayersInEveryTooth) {
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        for (const test::AverageTooth& average : test::kAverageTeeth) {
            SCOPED_TRACE(testing::Message() << "seed " << seed);
            const BuiltinTooth tooth = makeTooth({average.fdi, 5000, seed, {}});
            test::expectValidLayers(tooth);
            test::expectNestedLayers(tooth);
        }
    }
}

}  // namespace
}  // namespace tactooth
