// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/recording/mirror_moments.h"

#include <gtest/gtest.h>

#include <vector>

namespace tactooth {
namespace {

const MirrorSight kFirst = MirrorSight::of({}, 10, Vec3(1, 200, 50)), kLast = MirrorSight::of({}, 10, Vec3(0, 100, 90));

TEST(MirrorMoments, AMomentHoldsUntilTheNextOne) {
    const std::vector<MirrorMoment> moments = {{2, kFirst}, {5, kLast}, {5, MirrorSight()}, {9, kLast}};
    EXPECT_EQ(sightAt({}, 3), MirrorSight()) << "not recorded";
    EXPECT_EQ(sightAt(moments, 1), MirrorSight());
    for (const std::uint64_t ticks : {2U, 4U}) EXPECT_EQ(sightAt(moments, ticks), kFirst) << ticks;
    for (const std::uint64_t ticks : {5U, 8U}) EXPECT_EQ(sightAt(moments, ticks), MirrorSight()) << ticks;
    for (const std::uint64_t ticks : {9U, 1'000'000U}) EXPECT_EQ(sightAt(moments, ticks), kLast) << ticks;
}

TEST(MirrorMoments, TheFirstEyeIsThatWhichFirstSawTheMirror) {
    EXPECT_FALSE(firstEye({}));
    EXPECT_FALSE(firstEye(std::vector<MirrorMoment>{{0, MirrorSight()}}));
    EXPECT_EQ(firstEye(std::vector<MirrorMoment>{{0, MirrorSight()}, {3, kFirst}, {5, kLast}}), Vec3(1, 200, 50));
}

}  // namespace
}  // namespace tactooth
