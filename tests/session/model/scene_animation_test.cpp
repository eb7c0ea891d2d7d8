// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/scene_animation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "support/materials.h"

namespace tactooth {
namespace {

Tick cutting() {
    Tick tick;
    tick.input.cutting = true;
    tick.input.pedal = 1;
    tick.spindle.speedRpm = 300'000;
    return tick;
}

bool has(const SceneAnimation& scene, SprayParticleKind kind) {
    return std::ranges::any_of(scene.particles(), [&](const SprayParticle& one) { return one.kind == kind; });
}

TEST(SceneAnimation, TheBurTurnsByItsSpeed) {
    SceneAnimation scene;
    Tick tick;
    tick.spindle.speedRpm = 60;  // one turn a second
    scene.advance(tick, false, false, {}, 0.25);
    EXPECT_NEAR(scene.spin(), std::numbers::pi / 2, 1e-12);
    scene.advance(tick, false, false, {}, 0.5);
    EXPECT_NEAR(scene.spin(), -std::numbers::pi / 2, 1e-12) << "within half a turn of zero";
}

TEST(SceneAnimation, TheAngleIsThatOfAllTurnsTogether) {
    SceneAnimation scene;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> speed(0, 400'000), time(0.001, 0.1);
    double angle = 0;
    for (int i = 0; i < 1000; ++i) {
        Tick tick;
        tick.spindle.speedRpm = speed(random);
        const double dt = time(random);
        scene.advance(tick, false, false, {}, dt);
        angle += tick.spindle.speedRpm / 60 * 2 * std::numbers::pi * dt;
        ASSERT_LE(std::abs(scene.spin()), std::numbers::pi);
    }
    EXPECT_NEAR(std::remainder(scene.spin() - angle, 2 * std::numbers::pi), 0, 1e-4);
}

TEST(SceneAnimation, WaterFlowsWhileTheBurCuts) {
    SceneAnimation scene;
    for (int i = 0; i < 10; ++i) scene.advance(cutting(), true, false, {}, 0.01);
    EXPECT_TRUE(has(scene, SprayParticleKind::Jet));
}

TEST(SceneAnimation, NoWaterFlowsWhereItIsOffOrTheBurOnlyTouches) {
    SceneAnimation off, touching;
    Tick touch = cutting();
    touch.input.cutting = false;
    for (int i = 0; i < 10; ++i) {
        off.advance(cutting(), false, false, {}, 0.01);
        touching.advance(touch, true, false, {}, 0.01);
    }
    EXPECT_TRUE(off.particles().empty());
    EXPECT_TRUE(touching.particles().empty());
}

TEST(SceneAnimation, ChipsFlyForWhatIsGroundOff) {
    SceneAnimation scene;
    MaterialVolumes ground{};
    for (int i = 0; i < 20; ++i) {
        ground[static_cast<std::size_t>(test::kEnamel)] += SprayParticleSystem::kChipVolume * 5;
        scene.advance(cutting(), false, false, ground, 0.01);
    }
    EXPECT_TRUE(has(scene, SprayParticleKind::Chip));
}

TEST(SceneAnimation, ARestartRemovesTheParticlesAndKeepsTheAngle) {
    SceneAnimation scene;
    for (int i = 0; i < 10; ++i) scene.advance(cutting(), true, false, {}, 0.0101);
    const double angle = scene.spin();
    ASSERT_FALSE(scene.particles().empty());
    scene.restart(0.5, Vec3(3, 0, 0));
    EXPECT_TRUE(scene.particles().empty());
    EXPECT_EQ(scene.spin(), angle);
}

}  // namespace
}  // namespace tactooth
