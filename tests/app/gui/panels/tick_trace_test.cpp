// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/panels/tick_trace.h"

#include <gtest/gtest.h>

#include <numbers>

#include "support/shapes.h"

namespace tactooth {
namespace {

std::vector<Tick> ticks(double from, double to) {
    std::vector<Tick> result;
    for (int ms = static_cast<int>(from * 1000); ms < static_cast<int>(to * 1000); ++ms) {
        Tick tick;
        tick.time = ms / 1000.0;
        result.push_back(tick);
    }
    return result;
}

TEST(TickTrace, GivesTwentyPointsASecond) {
    TickTrace trace;
    trace.add(ticks(0, 1));
    EXPECT_EQ(trace.points().size(), 19U) << "the twentieth is still growing";
}

TEST(TickTrace, KeepsAPeakOfOneTick) {
    std::vector<Tick> some = ticks(0, 0.5);
    some[123].contact.depth = 0.4;
    some[124].input.speed = 70;
    some[125].force.wrench.force = Vec3(0, 3, 4);
    TickTrace trace;
    trace.add(some);
    EXPECT_FALSE(trace.isFlat());
    double depth = 0, speed = 0, force = 0;
    for (const TickTrace::Point& point : trace.points()) {
        depth = std::max(depth, point.depth);
        speed = std::max(speed, point.speed);
        force = std::max(force, point.force);
    }
    EXPECT_EQ(depth, 0.4);
    EXPECT_EQ(speed, 70);
    EXPECT_EQ(force, 5);
}

/// A bur that sinks by 0.1 mm a second into a box whose top is at z = 2, its shaft tilted by 60 degrees.
TEST(TickTrace, CavityDepthIsMeasuredAlongTheShaftFromTheUncutSurface) {
    const auto box = std::make_shared<const SurfacePart>(test::box(Vec3(-9, -9, -9), Vec3(9, 9, 2)));
    std::vector<Tick> some = ticks(0, 3);
    const Quat tilt(Eigen::AngleAxisd(std::numbers::pi / 3, Vec3::UnitX()));
    for (Tick& tick : some) tick.contact.proxy = {Vec3(0.3, 0.2, 2.1 - 0.1 * tick.time), tilt};
    TickTrace trace;
    trace.setUncut(box);
    trace.add(some);
    trace.clear();
    trace.add(some);
    for (const TickTrace::Point& point : trace.points()) {
        const double below = std::max(0.0, 0.1 * point.time - 0.1);
        constexpr double kTick = 0.0003;  // mm that it sinks along the shaft in a tick, and a little
        EXPECT_NEAR(point.cavityDepth, below / std::cos(std::numbers::pi / 3), kTick) << point.time;
    }
    trace.setUncut(nullptr);
    trace.add(ticks(3, 4));
    EXPECT_EQ(trace.points().back().cavityDepth, 0);
}

TEST(TickTrace, ForgetsWhatIsOlderThanThePlot) {
    std::vector<Tick> some = ticks(0, 12);
    some[100].contact.depth = 1;
    TickTrace trace;
    trace.add(some);
    EXPECT_GE(trace.points().front().time, trace.points().back().time - TickTrace::kShown - 1e-6);
    EXPECT_LE(trace.points().size(), 201U);
    EXPECT_TRUE(trace.isFlat());
}

TEST(TickTrace, ClearStartsANewSession) {
    TickTrace trace;
    trace.add(ticks(0, 5));
    trace.clear();
    trace.add(ticks(0, 0.2));
    EXPECT_EQ(trace.points().size(), 3U);
}

}  // namespace
}  // namespace tactooth
