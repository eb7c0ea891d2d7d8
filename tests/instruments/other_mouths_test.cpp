// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "geometry/mesh/mesh_report.h"
#include "instruments/mouth_checks.h"

namespace tactooth {
namespace {

TEST(OtherMouths, FitTogetherToo) {
    for (const std::uint32_t seed : {1U, 2U, 3U, 7U, 11U, 42U}) {
        const BuiltinMouth other = *makeMouth({.triangles = 2000, .seed = seed, .missing = {}});
        for (const int fdi : {12, 15, 17, 33, 36, 38}) {
            EXPECT_GT(test::between(test::placed(other, fdi - 1), test::placed(other, fdi)), 0) << seed << " " << fdi;
        }
        EXPECT_GT(test::between(test::placed(other, 16), test::placed(other, 46)), 0) << seed;
        for (const TriangleMesh* gingiva : {&other.upperGingiva, &other.lowerGingiva}) {
            EXPECT_TRUE(reportOn(*gingiva).watertight()) << seed;
            EXPECT_EQ(reportOn(*gingiva).shells.size(), 1u) << seed;
        }
    }
}

TEST(OtherMouths, HaveGumsThatDoNotIntersectThemselves) {
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        test::expectValidGingivae(*makeMouthLayout({.seed = seed, .missing = {}}));
    }
}

TEST(OtherMouths, HaveFineGumsAndHealedOnesThatDoNotIntersectThemselves) {
    test::expectValidGingivae(*makeMouthLayout({.triangles = 60000, .seed = 2, .missing = {}}));
    test::expectValidGingivae(*makeMouthLayout({.seed = 0, .missing = {18, 14, 24, 25, 41, 46, 47, 48}}));
}

}  // namespace
}  // namespace tactooth
