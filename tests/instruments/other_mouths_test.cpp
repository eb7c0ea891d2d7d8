// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "geometry/mesh_report.h"
#include "instruments/mouth_checks.h"

namespace tactooth {
namespace {

TEST(OtherMouths, FitTogetherToo) {
    for (const std::uint32_t seed : {1U, 2U, 3U, 7U, 11U, 42U}) {
        const BuiltinMouth other = makeMouth({.triangles = 2000, .seed = seed, .missing = {}});
        for (const int fdi : {12, 15, 17, 33, 36, 38}) {
            EXPECT_GT(test::between(test::placed(other, fdi - 1), test::placed(other, fdi)), 0) << seed << " " << fdi;
        }
        EXPECT_GT(test::between(test::placed(other, 16), test::placed(other, 46)), 0) << seed;
        for (const TriangleMesh* gum : {&other.upperGingiva, &other.lowerGingiva}) {
            EXPECT_TRUE(reportOn(*gum).watertight()) << seed;
            EXPECT_EQ(reportOn(*gum).shells.size(), 1u) << seed;
        }
    }
}

}  // namespace
}  // namespace tactooth
