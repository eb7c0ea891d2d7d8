// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/simulation/spray_particle_system.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace tactooth {
namespace {

constexpr double kFrame = 0.016;  // s
constexpr double kRadius = 0.6;   // mm
const Vec3 kTube(-12, -6, 3);

SprayInput drilling(double water = 1) {
    SprayInput moment;
    moment.toolInTooth = {Vec3(1, 2, 3), Quat(Eigen::AngleAxisd(0.4, Vec3::UnitX()))};
    moment.speedRpm = 300000;
    moment.water = water;
    return moment;
}

std::size_t count(const SprayParticleSystem& cloud, SprayParticleKind kind) {
    const auto particles = cloud.particles();
    return static_cast<std::size_t>(std::count_if(
        particles.begin(), particles.end(), [&](const SprayParticle& particle) { return particle.kind == kind; }));
}

TEST(SprayParticleSystem, NothingFliesWithoutWaterAndWithoutACut) {
    SprayParticleSystem cloud(kRadius, kTube);
    for (int i = 0; i < 20; ++i) cloud.advance(drilling(0), kFrame);
    EXPECT_TRUE(cloud.particles().empty());
}

TEST(SprayParticleSystem, ThrowsAsManyChipsOfEachMaterialAsWereRemoved) {
    SprayParticleSystem cloud(kRadius, kTube);
    SprayInput now = drilling(0);
    now.ground[0] = 5;  // cut before this cloud was there
    cloud.advance(now, kFrame);
    EXPECT_TRUE(cloud.particles().empty());
    const auto chip = SprayParticleSystem::kChipVolume;
    for (int i = 0; i < 4; ++i) {
        now.ground[0] += 10.8 * chip;
        now.ground[1] += 2.6 * chip;
        cloud.advance(now, kFrame);
    }
    const auto particles = cloud.particles();
    const auto of = [&](MaterialId id) {
        return std::count_if(particles.begin(), particles.end(),
                             [&](const SprayParticle& particle) { return particle.material == id; });
    };
    EXPECT_EQ(of(static_cast<MaterialId>(0)), 43);
    EXPECT_EQ(of(static_cast<MaterialId>(1)), 10);
    EXPECT_EQ(count(cloud, SprayParticleKind::Chip), 53U);
    EXPECT_NEAR(4.0 / 3 * 3.14159265 * std::pow(particles.front().radius, 3), chip, 1e-3 * chip);
}

TEST(SprayParticleSystem, ACutTakenBackThrowsNothingAndTheNextOneDoes) {
    SprayParticleSystem cloud(kRadius, kTube);
    SprayInput now = drilling(0);
    cloud.advance(now, kFrame);
    now.ground[0] = -3;  // as it looks from a baseline of 0
    cloud.advance(now, kFrame);
    EXPECT_TRUE(cloud.particles().empty());
    now.ground[0] += 4.5 * SprayParticleSystem::kChipVolume;
    cloud.advance(now, kFrame);
    EXPECT_EQ(count(cloud, SprayParticleKind::Chip), 4U);
}

TEST(SprayParticleSystem, MoreWaterMakesMoreMist) {
    const auto mistAt = [](double water) {
        SprayParticleSystem cloud(kRadius, kTube);
        for (int i = 0; i < 60; ++i) cloud.advance(drilling(water), kFrame);
        return static_cast<double>(count(cloud, SprayParticleKind::Mist));
    };
    const double full = mistAt(1);
    EXPECT_GT(full, 80);
    EXPECT_NEAR(mistAt(0.5), full / 2, 0.15 * full);
}

TEST(SprayParticleSystem, ThrownBitsStartAtTheRim) {
    SprayParticleSystem cloud(kRadius, kTube);
    SprayInput now = drilling(0);
    cloud.advance(now, kFrame);
    now.ground[0] = 200.5 * SprayParticleSystem::kChipVolume;
    cloud.advance(now, 1e-9);
    ASSERT_EQ(cloud.particles().size(), 200U);
    for (const SprayParticle& particle : cloud.particles()) {
        const Vec3 inTool = now.toolInTooth.inverse() * particle.place.cast<double>();
        EXPECT_NEAR(inTool.head<2>().norm(), kRadius, 1e-3);
        // Clockwise, seen from the shaft.
        const Vec3 velocity = now.toolInTooth.rotation.conjugate() * particle.velocity.cast<double>();
        EXPECT_GT(inTool.cross(Vec3(velocity.x(), velocity.y(), 0)).z() * -1, -0.1 * velocity.norm());
    }
}

TEST(SprayParticleSystem, AirBrakesWhatFliesAndNothingFliesIntoTheToothThatItLeaves) {
    SprayParticleSystem cloud(kRadius, kTube);
    SprayInput now = drilling(0);
    now.normal = Vec3(0, 0, 1);
    cloud.advance(now, kFrame);
    now.ground[0] = 0.2;
    cloud.advance(now, 1e-9);
    const double speed = 2 * 3.14159265 * kRadius * now.speedRpm / 60;
    std::vector<SprayParticle> before(cloud.particles().begin(), cloud.particles().end());
    for (const SprayParticle& particle : before) {
        EXPECT_LE(particle.velocity.norm(), 1.001 * speed);
        EXPECT_GT(particle.velocity.z(), 0);
    }
    cloud.advance(now, 0.1);
    ASSERT_EQ(cloud.particles().size(), before.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
        const SprayParticle& particle = cloud.particles()[i];
        const double reach = before[i].velocity.norm() * before[i].relaxation;
        EXPECT_NEAR((particle.place - before[i].place).head<2>().norm(),
                    before[i].velocity.head<2>().norm() * before[i].relaxation, 1e-3 * reach + 1e-4);
        EXPECT_LT(particle.velocity.norm(), 30);  // what is left is the slow fall
        EXPECT_LT(particle.velocity.z(), 0);
    }
}

TEST(SprayParticleSystem, EverythingIsGoneSoonAfterTheWaterIsOff) {
    SprayParticleSystem cloud(kRadius, kTube);
    for (int i = 0; i < 30; ++i) cloud.advance(drilling(1), kFrame);
    EXPECT_GT(count(cloud, SprayParticleKind::Jet), 0U);
    cloud.advance(drilling(0), kFrame);
    EXPECT_EQ(count(cloud, SprayParticleKind::Jet), 0U);
    EXPECT_GT(cloud.particles().size(), 0U);
    for (int i = 0; i < 30; ++i) cloud.advance(drilling(0), kFrame);
    EXPECT_TRUE(cloud.particles().empty());
}

TEST(SprayParticleSystem, TheSuctionTubeDrawsTheMistAway) {
    SprayParticleSystem free(kRadius, kTube), drawn(kRadius, kTube);
    SprayInput sucked = drilling(1);
    sucked.suction = true;
    for (int i = 0; i < 60; ++i) {
        free.advance(drilling(1), kFrame);
        drawn.advance(sucked, kFrame);
    }
    EXPECT_LT(count(drawn, SprayParticleKind::Mist), count(free, SprayParticleKind::Mist) / 2);
    EXPECT_GT(count(drawn, SprayParticleKind::Mist), 0U);
}

TEST(SprayParticleSystem, EverythingThatFliesIsDrawnTowardsTheTube) {
    const Vec3f tube(60, 0, 0);  // so far away that nothing arrives at once
    SprayParticleSystem free(kRadius, tube.cast<double>());
    for (int i = 0; i < 10; ++i) free.advance(drilling(1), kFrame);
    SprayParticleSystem drawn = free;
    SprayInput off = drilling(0);
    free.advance(off, 1e-3);
    off.suction = true;
    drawn.advance(off, 1e-3);
    ASSERT_GT(free.particles().size(), 50U);
    ASSERT_EQ(drawn.particles().size(), free.particles().size());
    for (std::size_t i = 0; i < free.particles().size(); ++i) {
        const float flow = 3.3e5F * 1e-3F / (6.2831853F * (free.particles()[i].place - tube).squaredNorm());  // mm
        EXPECT_NEAR((free.particles()[i].place - tube).norm() - (drawn.particles()[i].place - tube).norm(), flow,
                    0.05 * flow);
    }
}

TEST(SprayParticleSystem, NeverHoldsMoreThanAPictureAffords) {
    SprayParticleSystem cloud(kRadius, kTube);
    SprayInput now = drilling(1);
    for (int i = 0; i < 30; ++i) {
        now.ground[0] += 1;
        cloud.advance(now, kFrame);
        EXPECT_LE(cloud.particles().size(), SprayParticleSystem::kMaxParticles);
    }
}

TEST(SprayParticleSystem, EqualCallsGiveEqualBits) {
    SprayParticleSystem a(kRadius, kTube), b(kRadius, kTube);
    SprayInput now = drilling(0.7);
    for (int i = 0; i < 20; ++i) {
        now.ground[1] += 0.01;
        a.advance(now, kFrame);
        b.advance(now, kFrame);
    }
    ASSERT_EQ(a.particles().size(), b.particles().size());
    for (std::size_t i = 0; i < a.particles().size(); ++i) EXPECT_EQ(a.particles()[i].place, b.particles()[i].place);
}

}  // namespace
}  // namespace tactooth
