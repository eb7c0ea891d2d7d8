// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/scripts/touch_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "session/io/finite_tick.h"
#include "support/materials.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

StepwiseSession sessionOnABlock() {
    auto block = std::make_shared<const SurfacePart>(test::box(Vec3(-5, -5, -5), Vec3(5, 5, 0)));
    auto tooth = std::make_shared<const LayeredTooth>(LayeredTooth::touchOnly(std::move(block), true));
    return {std::make_shared<CutModel>(std::move(tooth), 0.05),
            {touchingTool(std::make_shared<const ToolShape>(test::sphere(Vec3(0, 0, 0.5), 0.5, 16, 8))),
             {},
             Placement::AtOnce}};
}

TEST(TouchRun, TakesOneTickARowAtTheRowsOwnTimes) {
    StepwiseSession session = sessionOnABlock();
    std::vector<TimedPose> trajectory;
    for (const double time : {3.0, 3.001, 3.001, 3.01}) {
        trajectory.push_back({time, {Vec3(0, 0, 4 - time), Quat::Identity()}});
    }
    std::vector<double> times;
    std::vector<Tick> ticks;
    ASSERT_TRUE(runTouchPath(trajectory, session, [&](double time, const Tick& tick) {
        times.push_back(time);
        ticks.push_back(tick);
    }));
    EXPECT_EQ(times, (std::vector<double>{3.0, 3.001, 3.001, 3.01}));
    EXPECT_NEAR(ticks[3].time, 0.01, 1e-12);
    EXPECT_NEAR(ticks[3].input.speed, 1, 1e-9);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(ticks[i].input.device.position, trajectory[i].toolInTooth.position);
        EXPECT_GT(ticks[i].diagnostics.micros, 0);
        EXPECT_EQ(ticks[i].spindle.speedRpm, 0);
    }
}

TEST(TouchRun, PressingIntoTheBlockPushesBack) {
    StepwiseSession session = sessionOnABlock();
    std::vector<TimedPose> trajectory;
    for (int i = 0; i < 100; ++i) trajectory.push_back({0.001 * i, {Vec3(0, 0, 0.1 - 0.004 * i), Quat::Identity()}});
    double strongest = 0;
    ASSERT_TRUE(runTouchPath(trajectory, session, [&](double, const Tick& tick) {
        strongest = std::max(strongest, tick.force.wrench.force.z());
    }));
    const Material enamel = MaterialTable{}[test::kEnamel];
    EXPECT_NEAR(strongest, 0.296 * enamel.stiffness + 4 * enamel.damping, 1e-5);
}

TEST(TouchRun, AnEmptyTrajectoryIsNoTick) {
    StepwiseSession session = sessionOnABlock();
    EXPECT_TRUE(runTouchPath({}, session, [](double, const Tick&) { FAIL(); }));
}

TEST(TouchRun, WhatIsNotFiniteInATickIsNamedWithItsTime) {
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), -1e308 * 10}) {
        const std::vector<std::pair<const char*, std::function<void(Tick&)>>> faults = {
            {"force", [&](Tick& tick) { tick.force.wrench.force.y() = bad; }},
            {"torque", [&](Tick& tick) { tick.force.wrench.torque.z() = bad; }},
            {"depth", [&](Tick& tick) { tick.contact.depth = bad; }},
            {"normal", [&](Tick& tick) { tick.contact.normal.x() = bad; }},
            {"proxy", [&](Tick& tick) { tick.contact.proxy.position.x() = bad; }},
            {"proxy", [&](Tick& tick) { tick.contact.proxy.rotation.w() = bad; }},
            {"hand", [&](Tick& tick) { tick.input.device.position.z() = bad; }},
            {"speed", [&](Tick& tick) { tick.input.speed = bad; }},
            {"speed of the bur", [&](Tick& tick) { tick.spindle.speedRpm = bad; }},
            {"work of the bur", [&](Tick& tick) { tick.spindle.cutWork = bad; }}};
        for (const auto& [what, spoil] : faults) {
            Tick tick;
            EXPECT_TRUE(checkFinite(0.25, tick));
            spoil(tick);
            const auto finite = checkFinite(0.25, tick);
            ASSERT_FALSE(finite) << what;
            EXPECT_TRUE(finite.error().message().starts_with("at t = 0.25 s the " + std::string(what) +
                                                             " is not a finite number, so nothing is written; "))
                << finite.error().message();
        }
    }
}

}  // namespace
}  // namespace tactooth
