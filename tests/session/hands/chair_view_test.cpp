// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/hands/chair_view.h"

#include <gtest/gtest.h>

#include <functional>

#include "instruments/builtin_tooth.h"

namespace tactooth {
namespace {

void forEachTooth(const std::function<void(int fdi)>& check) {
    for (int fdi = 11; fdi <= 48; ++fdi) {
        if (isPermanentTooth(fdi)) check(fdi);
    }
}

TEST(ChairView, IsFromNineToTwelveOClockAndAboveTheSideOfEveryTooth) {
    forEachTooth([](int fdi) {
        const ChairView chair = chairView(fdi);
        EXPECT_GE(chair.clock, 9) << fdi;
        EXPECT_LE(chair.clock, 12) << fdi;
        const Vec3 toEye = directionToEye(chair.view);
        EXPECT_GT(toEye.y(), 0) << fdi << ": the cheek side is nearer than the tongue";
        EXPECT_GE(mesialX(fdi) * toEye.x(), -1e-9) << fdi << ": one looks into the mouth from its front";
        EXPECT_GT(toEye.z(), 0.4) << fdi;
        EXPECT_LT(toEye.z(), 0.95) << fdi << ": the picture must not turn over";
    });
}

TEST(ChairView, OnlyTheUpperChewingSurfacesAreSeenByMirrorAndNearlySquareOn) {
    forEachTooth([](int fdi) {
        const ChairView chair = chairView(fdi);
        EXPECT_EQ(chair.mirror, fdi < 30 && !isAnteriorTooth(fdi)) << fdi;
        if (chair.mirror) {
            EXPECT_GT(directionToEye(chair.view).z(), 0.85) << fdi;
        }
    });
}

TEST(ChairView, OfALowerMolarLeavesRoomForTheHandpieceOnBothSides) {
    EXPECT_EQ(chairView(46).clock, 9);
    EXPECT_EQ(chairView(36).clock, 11);
    for (const int fdi : {36, 46}) {
        const ViewDirection usual = dentistView(mesialX(fdi));
        EXPECT_NEAR(chairView(fdi).view.azimuth, usual.azimuth, 0.01);
        EXPECT_NEAR(chairView(fdi).view.elevation, usual.elevation, 0.01);
    }
}

}  // namespace
}  // namespace tactooth
