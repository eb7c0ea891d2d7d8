// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/session_tooth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace tactooth {
namespace {

void expectView(const SessionTooth& tooth, int clock, bool mirror, const ViewDirection& view) {
    const ChairView chair = chairViewOf(tooth);
    EXPECT_EQ(chair.clock, clock);
    EXPECT_EQ(chair.mirror, mirror);
    EXPECT_LT((directionToEye(chair.view) - directionToEye(view)).norm(), 1e-12);
}

TEST(SessionTooth, IsSeenFromTheChairInAMouthAndAlone) {
    for (const int fdi : {11, 16, 26, 34, 46}) {
        const ChairView chair = chairView(fdi);
        SessionTooth inMouth{.name = "one", .piece = {}, .mesialX = mesialX(fdi), .provenance = {}};
        SessionTooth alone = inMouth;
        inMouth.mouthTooth = fdi;
        alone.fdi = fdi;
        expectView(inMouth, chair.clock, chair.mirror, chair.view);
        expectView(alone, chair.clock, chair.mirror, chair.view);
    }
}

TEST(SessionTooth, IsKnownByTheNameOfItsFile) {
    const SessionTooth file{.name = "lower-44.stl", .piece = {}, .mesialX = mesialX(44), .provenance = {}};
    EXPECT_EQ(fdiOfTooth(file), 44);
    expectView(file, 9, false, chairView(44).view);
}

TEST(SessionTooth, IsSeenFromBuccalAndAboveWhereItsNumberIsNotKnownOrDoesNotFitItsFrame) {
    for (const double x : {1.0, -1.0}) {
        expectView({.name = "scan", .piece = {}, .mesialX = x, .provenance = {}}, 0, false, dentistView(x));
    }
    const double other = -mesialX(26);
    expectView({.name = "26.stl", .piece = {}, .mesialX = other, .provenance = {}}, 0, false, dentistView(other));
}

TEST(SessionTooth, SaysHowMuchOfItIsMade) {
    for (const BuiltinToothEntry& entry : kBuiltinTeeth) {
        std::vector<double> shares;
        ASSERT_TRUE(makeSessionTooth(entry, [&](double share) { shares.push_back(share); }));
        EXPECT_GE(shares.size(), 2u);
        EXPECT_TRUE(std::ranges::is_sorted(shares));
        EXPECT_EQ(shares.back(), 1);
    }
}

}  // namespace
}  // namespace tactooth
