// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The same path sampled at 1 and 4 kHz: the removed volume must not depend on the sampling.
#include "session/scripts/cut_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "session/cut_outcome.h"
#include "session/scripts/softened_materials.h"
#include "support/materials.h"
#include "support/servo_tick.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

using test::CutOutcome;

constexpr double kSpeed = 300'000;  // rev/min
constexpr double kRadius = 0.5;     // mm
constexpr double kFeed = 5;         // mm/s
constexpr double kSlot = 1;         // mm
using test::kTick;

struct Slot {
    TriangleMesh bur;
    double voxel;  // mm
    double depth;  // mm
};

/// Ball and cylinder, a scratch and a groove.
std::vector<Slot> slots() {
    std::vector<Slot> all;
    for (const double voxel : {0.05, 0.025}) {
        for (const double depth : {0.02, 0.1}) {
            all.push_back({test::sphere(Vec3(0, 0, kRadius), kRadius, 48, 24), voxel, depth});
            all.push_back({test::cylinder(Vec3::Zero(), kRadius, 4, 64), voxel, depth});
        }
    }
    return all;
}

std::shared_ptr<const LayeredTooth> block() {
    return std::make_shared<const LayeredTooth>(
        std::move(*LayeredTooth::make(test::box(Vec3(-2, -2, -2), Vec3(2, 2, 0)), {}, test::kDentin)));
}

/// Down into the block and on along x, where the bur rests for a tenth of a second.
std::vector<TimedPose> pathOf(const Slot& slot, double tick) {
    std::vector<TimedPose> path;
    const auto add = [&](double x, double z) {
        path.push_back({static_cast<double>(path.size()) * tick, {Vec3(x, 0.013, z), Quat::Identity()}});
    };
    constexpr double kAbove = 0.05;
    const double step = kFeed * tick;
    for (int i = 0; i < std::lround((kAbove + slot.depth) / step); ++i) add(-0.5 * kSlot, kAbove - i * step);
    for (int i = 0; i < std::lround(kSlot / step); ++i) add(-0.5 * kSlot + i * step, -slot.depth);
    for (int i = 0; i <= std::lround(0.1 / tick); ++i) add(0.5 * kSlot, -slot.depth);
    return path;
}

Instrument burOf(const Slot& slot) {
    return {std::make_shared<const ToolShape>(slot.bur), {*RevolutionEnvelope::make(slot.bur), 1}};
}

CutOutcome sweptRigidly(const Slot& slot, double tick) {
    const auto piece = std::make_shared<CutModel>(block(), slot.voxel);
    StepwiseSession session(piece, rigidCutSetup(burOf(slot), {}, kSpeed));
    EXPECT_TRUE(cutKinematically(pathOf(slot, tick), true, session, [](double, const Tick&, const ToothLoss&) {}));
    return CutOutcome(*piece);
}

/// With a bur that does not lag behind the device.
CutOutcome cutOutByLaw(const Slot& slot, double tick) {
    const auto piece = std::make_shared<CutModel>(block(), slot.voxel);
    HapticSettings settings;
    settings.materials = softenedMaterials(1000);
    settings.spindle = constantSpeed(kSpeed);
    StepwiseSession session(piece, cutSetup(burOf(slot), settings));
    EXPECT_TRUE(cutWithRemovalLaw(pathOf(slot, tick), session, [](double, const Tick&, const ToothLoss&) {}));
    return CutOutcome(*piece);
}

TEST(CutRun, APathSweptInStepsOfFourKilohertzLeavesWhatOneLeaves) {
    for (const Slot& slot : slots()) {
        SCOPED_TRACE(testing::Message() << slot.voxel << ' ' << slot.depth);
        test::expectSame(sweptRigidly(slot, kTick), sweptRigidly(slot, kTick / 4));
    }
}

TEST(CutRun, ABurThatKeepsUpLeavesTheSameAtOneAndFourKilohertz) {
    for (const Slot& slot : slots()) {
        SCOPED_TRACE(testing::Message() << slot.voxel << ' ' << slot.depth);
        test::expectSame(cutOutByLaw(slot, kTick), cutOutByLaw(slot, kTick / 4));
    }
}

}  // namespace
}  // namespace tactooth
