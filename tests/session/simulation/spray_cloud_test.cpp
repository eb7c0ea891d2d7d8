// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/simulation/spray_cloud.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace tactooth {
namespace {

constexpr double kFrame = 0.016;  // s
constexpr double kRadius = 0.6;   // mm
const Vec3 kTube(-12, -6, 3);

SprayMoment drilling(double water = 1) {
    SprayMoment moment;
    moment.toolInTooth = {Vec3(1, 2, 3), Quat(Eigen::AngleAxisd(0.4, Vec3::UnitX()))};
    moment.speedRpm = 300000;
    moment.water = water;
    return moment;
}

std::size_t count(const SprayCloud& cloud, FlyingKind kind) {
    const auto bits = cloud.bits();
    return static_cast<std::size_t>(
        std::count_if(bits.begin(), bits.end(), [&](const FlyingBit& bit) { return bit.kind == kind; }));
}

TEST(SprayCloud, NothingFliesWithoutWaterAndWithoutACut) {
    SprayCloud cloud(kRadius, kTube);
    for (int i = 0; i < 20; ++i) cloud.advance(drilling(0), kFrame);
    EXPECT_TRUE(cloud.bits().empty());
}

TEST(SprayCloud, ThrowsAsManyChipsOfEachMaterialAsWereRemoved) {
    SprayCloud cloud(kRadius, kTube);
    SprayMoment now = drilling(0);
    now.ground[0] = 5;  // cut before this cloud was there
    cloud.advance(now, kFrame);
    EXPECT_TRUE(cloud.bits().empty());
    const auto chip = SprayCloud::kChipVolume;
    for (int i = 0; i < 4; ++i) {
        now.ground[0] += 10.8 * chip;
        now.ground[1] += 2.6 * chip;
        cloud.advance(now, kFrame);
    }
    const auto bits = cloud.bits();
    const auto of = [&](MaterialId id) {
        return std::count_if(bits.begin(), bits.end(), [&](const FlyingBit& bit) { return bit.material == id; });
    };
    EXPECT_EQ(of(static_cast<MaterialId>(0)), 43);
    EXPECT_EQ(of(static_cast<MaterialId>(1)), 10);
    EXPECT_EQ(count(cloud, FlyingKind::Chip), 53U);
    EXPECT_NEAR(4.0 / 3 * 3.14159265 * std::pow(bits.front().radius, 3), chip, 1e-3 * chip);
}

TEST(SprayCloud, ACutTakenBackThrowsNothingAndTheNextOneDoes) {
    SprayCloud cloud(kRadius, kTube);
    SprayMoment now = drilling(0);
    cloud.advance(now, kFrame);
    now.ground[0] = -3;  // as it looks from a baseline of 0
    cloud.advance(now, kFrame);
    EXPECT_TRUE(cloud.bits().empty());
    now.ground[0] += 4.5 * SprayCloud::kChipVolume;
    cloud.advance(now, kFrame);
    EXPECT_EQ(count(cloud, FlyingKind::Chip), 4U);
}

TEST(SprayCloud, MoreWaterMakesMoreMist) {
    const auto mistAt = [](double water) {
        SprayCloud cloud(kRadius, kTube);
        for (int i = 0; i < 60; ++i) cloud.advance(drilling(water), kFrame);
        return static_cast<double>(count(cloud, FlyingKind::Mist));
    };
    const double full = mistAt(1);
    EXPECT_GT(full, 80);
    EXPECT_NEAR(mistAt(0.5), full / 2, 0.15 * full);
}

TEST(SprayCloud, ThrownBitsStartAtTheRim) {
    SprayCloud cloud(kRadius, kTube);
    SprayMoment now = drilling(0);
    cloud.advance(now, kFrame);
    now.ground[0] = 200.5 * SprayCloud::kChipVolume;
    cloud.advance(now, 1e-9);
    ASSERT_EQ(cloud.bits().size(), 200U);
    for (const FlyingBit& bit : cloud.bits()) {
        const Vec3 inTool = now.toolInTooth.inverse() * bit.place.cast<double>();
        EXPECT_NEAR(inTool.head<2>().norm(), kRadius, 1e-3);
        // Clockwise, seen from the shaft.
        const Vec3 velocity = now.toolInTooth.rotation.conjugate() * bit.velocity.cast<double>();
        EXPECT_GT(inTool.cross(Vec3(velocity.x(), velocity.y(), 0)).z() * -1, -0.1 * velocity.norm());
    }
}

TEST(SprayCloud, AirBrakesWhatFliesAndNothingFliesIntoTheToothThatItLeaves) {
    SprayCloud cloud(kRadius, kTube);
    SprayMoment now = drilling(0);
    now.normal = Vec3(0, 0, 1);
    cloud.advance(now, kFrame);
    now.ground[0] = 0.2;
    cloud.advance(now, 1e-9);
    const double speed = 2 * 3.14159265 * kRadius * now.speedRpm / 60;
    std::vector<FlyingBit> before(cloud.bits().begin(), cloud.bits().end());
    for (const FlyingBit& bit : before) {
        EXPECT_LE(bit.velocity.norm(), 1.001 * speed);
        EXPECT_GT(bit.velocity.z(), 0);
    }
    cloud.advance(now, 0.1);
    ASSERT_EQ(cloud.bits().size(), before.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
        const FlyingBit& bit = cloud.bits()[i];
        const double reach = before[i].velocity.norm() * before[i].relaxation;
        EXPECT_NEAR((bit.place - before[i].place).head<2>().norm(),
                    before[i].velocity.head<2>().norm() * before[i].relaxation, 1e-3 * reach + 1e-4);
        EXPECT_LT(bit.velocity.norm(), 30);  // what is left is the slow fall
        EXPECT_LT(bit.velocity.z(), 0);
    }
}

TEST(SprayCloud, EverythingIsGoneSoonAfterTheWaterIsOff) {
    SprayCloud cloud(kRadius, kTube);
    for (int i = 0; i < 30; ++i) cloud.advance(drilling(1), kFrame);
    EXPECT_GT(count(cloud, FlyingKind::Jet), 0U);
    cloud.advance(drilling(0), kFrame);
    EXPECT_EQ(count(cloud, FlyingKind::Jet), 0U);
    EXPECT_GT(cloud.bits().size(), 0U);
    for (int i = 0; i < 30; ++i) cloud.advance(drilling(0), kFrame);
    EXPECT_TRUE(cloud.bits().empty());
}

TEST(SprayCloud, TheSuctionTubeDrawsTheMistAway) {
    SprayCloud free(kRadius, kTube), drawn(kRadius, kTube);
    SprayMoment sucked = drilling(1);
    sucked.suction = true;
    for (int i = 0; i < 60; ++i) {
        free.advance(drilling(1), kFrame);
        drawn.advance(sucked, kFrame);
    }
    EXPECT_LT(count(drawn, FlyingKind::Mist), count(free, FlyingKind::Mist) / 2);
    EXPECT_GT(count(drawn, FlyingKind::Mist), 0U);
}

TEST(SprayCloud, EverythingThatFliesIsDrawnTowardsTheTube) {
    const Vec3f tube(60, 0, 0);  // so far away that nothing arrives at once
    SprayCloud free(kRadius, tube.cast<double>());
    for (int i = 0; i < 10; ++i) free.advance(drilling(1), kFrame);
    SprayCloud drawn = free;
    SprayMoment off = drilling(0);
    free.advance(off, 1e-3);
    off.suction = true;
    drawn.advance(off, 1e-3);
    ASSERT_GT(free.bits().size(), 50U);
    ASSERT_EQ(drawn.bits().size(), free.bits().size());
    for (std::size_t i = 0; i < free.bits().size(); ++i) {
        const float flow = 3.3e5F * 1e-3F / (6.2831853F * (free.bits()[i].place - tube).squaredNorm());  // mm
        EXPECT_NEAR((free.bits()[i].place - tube).norm() - (drawn.bits()[i].place - tube).norm(), flow, 0.05 * flow);
    }
}

TEST(SprayCloud, NeverHoldsMoreThanAPictureAffords) {
    SprayCloud cloud(kRadius, kTube);
    SprayMoment now = drilling(1);
    for (int i = 0; i < 30; ++i) {
        now.ground[0] += 1;
        cloud.advance(now, kFrame);
        EXPECT_LE(cloud.bits().size(), SprayCloud::kMostBits);
    }
}

TEST(SprayCloud, EqualCallsGiveEqualBits) {
    SprayCloud a(kRadius, kTube), b(kRadius, kTube);
    SprayMoment now = drilling(0.7);
    for (int i = 0; i < 20; ++i) {
        now.ground[1] += 0.01;
        a.advance(now, kFrame);
        b.advance(now, kFrame);
    }
    ASSERT_EQ(a.bits().size(), b.bits().size());
    for (std::size_t i = 0; i < a.bits().size(); ++i) EXPECT_EQ(a.bits()[i].place, b.bits()[i].place);
}

}  // namespace
}  // namespace tactooth
