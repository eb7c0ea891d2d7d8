// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The force while a bur mills a slot at a steady feed from decay into sound enamel: no step at the boundary, no
// oscillation at the rate of new surfaces.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "session/scripts/cut_run.h"
#include "support/materials.h"
#include "support/servo_tick.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

using test::kTick;
constexpr double kVoxel = 0.05;     // mm
constexpr double kFeed = 0.5;       // mm/s
constexpr double kSpeed = 300'000;  // rev/min
constexpr double kRadius = 0.5;     // mm
constexpr double kFrom = -0.4;      // mm; the boundary is at 0
constexpr double kTravel = 1.2;     // mm

std::shared_ptr<const LayeredTooth> halfDecayedBlock() {
    std::vector<LayerMesh> layers;
    layers.push_back({"sound", test::kEnamel, test::box(Vec3(-2, -2, -2), Vec3(2, 2, 0))});
    layers.push_back({"decay", test::kCaries, test::box(Vec3(-2, -2, -2), Vec3(0, 2, 0))});
    return std::make_shared<const LayeredTooth>(
        std::move(*LayeredTooth::make(test::box(Vec3(-2, -2, -2), Vec3(2, 2, 0)), std::move(layers))));
}

/// Down into the decay, 0.25 mm deep, and on along x.
std::vector<TimedPose> millingPath() {
    std::vector<TimedPose> path;
    const auto add = [&](double x, double z) {
        path.push_back({static_cast<double>(path.size()) * kTick, {Vec3(x, 0.013, z), Quat::Identity()}});
    };
    for (double z = 0.05; z > -0.25; z -= kFeed * kTick) add(kFrom, z);
    for (double x = kFrom; x < kFrom + kTravel; x += kFeed * kTick) add(x, -0.25);
    return path;
}

struct CutForces {
    std::vector<double> normal;  // N, one a tick
    std::vector<Vec3> force;
};

CutForces mill() {
    const TriangleMesh bur = test::sphere(Vec3(0, 0, kRadius), kRadius, 48, 24);
    const CuttingTool tool{*RevolutionEnvelope::make(bur), 1};
    const auto piece = std::make_shared<CutModel>(halfDecayedBlock(), kVoxel);
    HapticSettings settings;
    settings.spindle = constantSpeed(kSpeed);
    StepwiseSession session(piece, cutSetup({std::make_shared<const ToolShape>(bur), tool}, settings));
    const double rimTravel = kSpeed / 60 * 2 * std::numbers::pi * kRadius * 1e-3 * kTick;  // m a tick
    CutForces forces;
    double work = 0;
    EXPECT_TRUE(cutWithRemovalLaw(millingPath(), session, [&](double, const Tick& tick, const ToothLoss&) {
        forces.normal.push_back((tick.spindle.cutWork - work) / rimTravel);
        forces.force.push_back(tick.force.wrench.force);
        work = tick.spindle.cutWork;
    }));
    return forces;
}

const CutForces& forces() {
    static const CutForces once = mill();
    return once;
}

TEST(SteadyCutting, NoStepAboveATenthOfANewtonAMillisecondFromDecayIntoEnamel) {
    double largest = 0;
    for (std::size_t i = 1; i < forces().normal.size(); ++i) {
        largest = std::max(largest, std::abs(forces().normal[i] - forces().normal[i - 1]));
    }
    EXPECT_LT(largest, 0.1);
    const double inDecay = std::accumulate(forces().normal.end() - 2000, forces().normal.end() - 1900, 0.0);
    const double inEnamel = std::accumulate(forces().normal.end() - 100, forces().normal.end(), 0.0);
    EXPECT_GT(inDecay, 0);
    EXPECT_GT(inEnamel, 1.2 * inDecay);
    RecordProperty("largestStepMillinewton", static_cast<int>(1000 * largest));
}

TEST(SteadyCutting, AtASteadyFeedTheForceRipplesByLessThanAHandFeels) {
    constexpr std::size_t kWindow = 25;  // ticks to either side
    const std::vector<double>& force = forces().normal;
    double squares = 0;
    std::size_t count = 0;
    for (std::size_t i = force.size() - 500; i + kWindow < force.size(); ++i) {
        double mean = 0;
        for (std::size_t j = i - kWindow; j <= i + kWindow; ++j) mean += force[j] / (2 * kWindow + 1);
        squares += (force[i] - mean) * (force[i] - mean);
        ++count;
    }
    const double ripple = std::sqrt(squares / static_cast<double>(count));
    EXPECT_LT(ripple, 0.02);
    RecordProperty("rippleMillinewton", static_cast<int>(1000 * ripple));
}

TEST(SteadyCutting, TheBurIsPulledAcrossItsFeedAgainstItsRotation) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = forces().force.size() - 500; i < forces().force.size(); ++i) sum += forces().force[i] / 500;
    // Fed toward +x and turning clockwise seen from the shaft, the bur's front runs toward -y.
    EXPECT_LT(sum.x(), 0);
    EXPECT_GT(sum.y(), 0.2 * -sum.x());
}

}  // namespace
}  // namespace tactooth
