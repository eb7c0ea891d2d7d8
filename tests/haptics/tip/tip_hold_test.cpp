// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/tip/tip_hold.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "haptics/haptic_simulation.h"
#include "haptics/scene.h"
#include "support/materials.h"
#include "support/servo_tick.h"

namespace tactooth {
namespace {

using test::at;

using test::kTick;
constexpr double kSpeed = 5;  // mm/s, of the hand
constexpr double kGrip = 4, kSinking = 0.15;

HapticSimulation explorerOn(MaterialId tissue) {
    static const auto explorer = std::make_shared<const ToolShape>(touchingInstrument(HandInstrument::Explorer));
    HapticSettings settings;
    settings.force.friction = 0;
    HapticSimulation simulation(explorer, 0, test::block(tissue), settings);
    simulation.holdByHand(HandInstrument::Explorer, settings.materials);
    return simulation;
}

/// Brings the tip down, keeps it `depth` mm in for some time, and draws it out along `direction`. `pressed`: the force
/// before, N. Returns the largest force against the hand.
double pullOut(HapticSimulation& simulation, double depth, double seconds, const Vec3& direction, double& pressed) {
    constexpr double kDown = 20;  // mm/s
    for (double z = 0.1; z > -depth; z -= kDown * kTick) (void)simulation.step({at(0, 0, z), 0, false}, kTick);
    Tick tick;
    for (double t = 0; t < seconds; t += kTick) tick = simulation.step({at(0, 0, -depth), 0, false}, kTick);
    pressed = tick.force.wrench.force.z();
    double largest = 0;
    Vec3 hand(0, 0, -depth);
    for (int i = 0; i < 2000; ++i) {
        hand += kSpeed * kTick * direction;
        tick = simulation.step({{hand, Quat::Identity()}, 0, false}, kTick);
        largest = std::max(largest, -tick.force.wrench.force.dot(direction));
    }
    return largest;
}

double pullOut(HapticSimulation& simulation, double depth, double seconds, const Vec3& direction) {
    double pressed = 0;
    return pullOut(simulation, depth, seconds, direction, pressed);
}

/// Brings the tip down at `x` and presses it 0.4 mm in for half a second. Returns the last tick.
Tick press(HapticSimulation& simulation, double x = 0) {
    Tick tick = simulation.step({at(x, 0, 0.2), 0, false}, kTick);
    for (int i = 0; i < 500; ++i) tick = simulation.step({at(x, 0, -0.4), 0, false}, kTick);
    return tick;
}

/// A tick with the hand 2 mm above the block, farther than any hold reaches.
Tick lift(HapticSimulation& simulation, double x = 0) { return simulation.step({at(x, 0, 2), 0, false}, kTick); }

TEST(TipHold, OnlyDecayIsSoftAndTheMoreTheLessStiffItIs) {
    MaterialTable materials;
    for (const MaterialId id : {test::kEnamel, test::kDentin, test::kPulp, test::kRestoration, test::kOther}) {
        EXPECT_EQ(softness(materials, id), 0);
    }
    EXPECT_NEAR(softness(materials, test::kCaries), 1 - materials[test::kCaries].stiffness / 0.5, 1e-12);
    materials[test::kCaries].stiffness = 0.6;  // arrested
    EXPECT_EQ(softness(materials, test::kCaries), 0);
}

TEST(TipHold, SoftDecayHoldsTheTipWithTheForceThatTheLawGives) {
    const MaterialTable materials;
    for (const double depth : {0.3, 0.6}) {
        HapticSimulation simulation = explorerOn(test::kCaries);
        double pressed = 0;
        const double pulled = pullOut(simulation, depth, 1, Vec3::UnitZ(), pressed);
        const Material& caries = materials[test::kCaries];
        EXPECT_NEAR(pressed, caries.stiffness * depth, 0.03);  // the tip itself is blunt
        const double expected = kGrip * softness(materials, test::kCaries) * pressed * (1 - std::exp(-1 / kSinking));
        // One tick of the hand, and the damper.
        EXPECT_NEAR(pulled, expected, caries.stiffness * kSpeed * kTick + caries.damping * kSpeed + 0.002) << depth;
    }
}

TEST(TipHold, SoundTissueLetsTheTipGo) {
    for (const MaterialId tissue : {test::kEnamel, test::kDentin}) {
        HapticSimulation simulation = explorerOn(tissue);
        EXPECT_EQ(pullOut(simulation, 0.4, 1, Vec3::UnitZ()), 0);
        EXPECT_EQ(pullOut(simulation, 0.4, 1, Vec3::UnitX()), 0);  // it slides: without friction nothing resists
    }
}

TEST(TipHold, AlsoHoldsTheTipAside) {
    HapticSimulation simulation = explorerOn(test::kCaries);
    EXPECT_GT(pullOut(simulation, 0.4, 1, Vec3::UnitX()), 0.15);
}

TEST(TipHold, AShortTouchHoldsLess) {
    HapticSimulation brief = explorerOn(test::kCaries), slow = explorerOn(test::kCaries);
    EXPECT_LT(pullOut(brief, 0.4, 0.03, Vec3::UnitZ()), 0.5 * pullOut(slow, 0.4, 1, Vec3::UnitZ()));
}

TEST(TipHold, TheTipStaysWhereItIsUntilItComesFree) {
    HapticSimulation simulation = explorerOn(test::kCaries);
    (void)simulation.step({at(0, 0, 0.2), 0, false}, kTick);
    Tick tick;
    for (int i = 0; i < 1000; ++i) tick = simulation.step({at(0, 0, -0.4), 0, false}, kTick);
    const Vec3 place = tick.contact.proxy.position;
    EXPECT_GT(tick.force.tipHold, 0.1);
    tick = simulation.step({at(0, 0, 0.3), 0, false}, kTick);
    EXPECT_EQ(tick.contact.proxy.position, place);
    EXPECT_LT(tick.force.wrench.force.z(), 0);
    tick = simulation.step({at(0, 0, 2), 0, false}, kTick);
    EXPECT_EQ(tick.force.tipHold, 0);
    EXPECT_EQ(tick.contact.triangles, 0);
    EXPECT_EQ(tick.contact.proxy.position, Vec3(0, 0, 2));
}

TEST(TipHold, CountsEachPullOutOnceWithTheHoldThatWasOvercome) {
    HapticSimulation simulation = explorerOn(test::kCaries);
    for (std::uint32_t time = 1; time <= 3; ++time) {
        const Tick held = press(simulation, 0.3 * time);
        EXPECT_GT(held.force.tipHold, 0.1);
        EXPECT_EQ(held.contact.pullOuts, time - 1);
        for (int i = 0; i < 10; ++i) {
            const Tick freed = lift(simulation, 0.3 * time);
            ASSERT_EQ(freed.contact.pullOuts, time) << i;
            ASSERT_EQ(freed.contact.pullOutForce, held.force.tipHold) << i;
        }
    }
}

TEST(TipHold, ASlowPullIsOnePullOut) {
    HapticSimulation simulation = explorerOn(test::kCaries);
    (void)pullOut(simulation, 0.4, 1, Vec3::UnitZ());
    EXPECT_EQ(lift(simulation).contact.pullOuts, 1U);
}

TEST(TipHold, ATouchOfSoundTissueLeavesTheCountOfPullOuts) {
    HapticSimulation simulation = explorerOn(test::kCaries);
    (void)press(simulation);
    const Tick freed = lift(simulation);
    ASSERT_EQ(freed.contact.pullOuts, 1U);
    (void)simulation.setSurface(test::block(test::kEnamel));
    const Tick touched = press(simulation);
    EXPECT_GT(touched.contact.triangles, 0);
    const Tick lifted = lift(simulation);
    EXPECT_EQ(lifted.contact.pullOuts, 1U);
    EXPECT_EQ(lifted.contact.pullOutForce, freed.contact.pullOutForce);
}

TEST(TipHold, AFaultyPoseIsNoPullOutAndLeavesTheCount) {
    HapticSimulation simulation = explorerOn(test::kCaries);
    (void)press(simulation);
    const Tick freed = lift(simulation);
    ASSERT_EQ(freed.contact.pullOuts, 1U);
    ASSERT_GT(press(simulation).force.tipHold, 0.1);
    const Tick faulty = simulation.step({at(0, 0, std::nan("")), 0, false}, kTick);
    ASSERT_FALSE(faulty.contact.placed);
    EXPECT_EQ(faulty.force.tipHold, 0);
    for (const Tick& tick : {faulty, lift(simulation)}) {
        EXPECT_EQ(tick.contact.pullOuts, 1U);
        EXPECT_EQ(tick.contact.pullOutForce, freed.contact.pullOutForce);
    }
    (void)press(simulation);
    EXPECT_EQ(lift(simulation).contact.pullOuts, 2U);
}

TEST(TipHold, AToothThatIsPutBackUnderTheTipIsNoPullOut) {
    for (const MaterialId tissue : {test::kCaries, test::kEnamel}) {
        HapticSimulation simulation = explorerOn(test::kCaries);
        ASSERT_GT(press(simulation).force.tipHold, 0.1);
        (void)simulation.setSurface(test::block(tissue));
        for (int i = 0; i < 10; ++i) (void)simulation.step({at(0.2, 0, -0.4), 0, false}, kTick);
        EXPECT_EQ(lift(simulation).contact.pullOuts, 0U);
        (void)simulation.setSurface(test::block(test::kCaries));
        (void)press(simulation);
        EXPECT_EQ(lift(simulation).contact.pullOuts, 1U) << "the next one counts again";
    }
}

TEST(TipHold, ATipThatIsDraggedOnWithinTheDecayHasNotComeFree) {
    HapticSimulation simulation = explorerOn(test::kCaries);
    Tick tick = press(simulation);
    for (int i = 0; i < 400; ++i) tick = simulation.step({at(kSpeed * kTick * i, 0, -0.4), 0, false}, kTick);
    EXPECT_GT(tick.contact.proxy.position.x(), 0.5) << "it did slip";
    EXPECT_GT(tick.force.tipHold, 0);
    EXPECT_EQ(tick.contact.pullOuts, 0U);
    EXPECT_EQ(lift(simulation, 2).contact.pullOuts, 1U);
}

TEST(TipHold, NothingTurnsInTheHand) {
    HapticSimulation simulation = explorerOn(test::kEnamel);
    Tick tick;
    for (int i = 0; i < 500; ++i) tick = simulation.step({at(0, 0, -0.2), 1, true}, kTick);
    EXPECT_FALSE(tick.input.cutting);
    EXPECT_EQ(tick.input.pedal, 0);
    EXPECT_EQ(tick.spindle.speedRpm, 0);
    EXPECT_EQ(tick.spindle.cutWork, 0);
}

}  // namespace
}  // namespace tactooth
