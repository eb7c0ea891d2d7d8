// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// A material holds the bur back while the device pose moves on. The removed volume must not depend on the tick rate.
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "session/cut_outcome.h"
#include "session/scripts/cut_run.h"
#include "support/materials.h"
#include "support/servo_tick.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

using test::CutOutcome;

constexpr double kSpeed = 300'000;  // rev/min
constexpr double kRadius = 0.5;     // mm
constexpr double kVoxel = 0.025;    // mm
using test::kTick;
constexpr double kRest = 0.1;  // s at the end

struct HeldBack {
    std::string name;
    MaterialId material;
    bool isBall;  // or else a cylinder
    double feed;  // of the hand, mm/s
    std::vector<Vec3> corners;
};

void PrintTo(const HeldBack& one, std::ostream* stream) { *stream << one.name; }

/// The block is full below 0 and ends at x = 2.
std::vector<HeldBack> all() {
    const double y = 0.013;
    const auto slot = [y](double depth) {
        return std::vector{Vec3(-1, y, 0.05), Vec3(-1, y, -depth), Vec3(1, y, -depth)};
    };
    const std::vector down = {Vec3(0.007, y, 0.05), Vec3(0.007, y, -0.5)};
    const std::vector slanting = {Vec3(-1, y, 0.05), Vec3(1, y, -0.3)};
    const std::vector beside = {Vec3(2.55, -0.5, -1), Vec3(2.4, -0.5, -1), Vec3(2.4, 0.5, -1)};
    return {{"slotInCaries", test::kCaries, true, 5, slot(0.1)},
            {"slowSlotInDentin", test::kDentin, true, 2, slot(0.1)},
            {"scratchInCaries", test::kCaries, true, 5, slot(0.02)},
            {"deepSlotInDentin", test::kDentin, true, 5, slot(0.3)},
            {"slotInEnamel", test::kEnamel, true, 5, slot(0.1)},
            {"holeInDentin", test::kDentin, true, 1, down},
            {"slantingInCaries", test::kCaries, true, 5, slanting},
            {"wallOfDentin", test::kDentin, true, 5, beside},
            {"cylinderSlotInCaries", test::kCaries, false, 5, slot(0.3)},
            {"cylinderHoleInCaries", test::kCaries, false, 5, down}};
}

/// The path in steps of `tick` s; positions depend on time alone.
std::vector<TimedPose> pathOf(const HeldBack& one, double tick) {
    std::vector<TimedPose> path;
    const auto add = [&](const Vec3& position) {
        path.push_back({static_cast<double>(path.size()) * tick, {position, Quat::Identity()}});
    };
    for (std::size_t i = 1; i < one.corners.size(); ++i) {
        const Vec3 leg = one.corners[i] - one.corners[i - 1];
        const long ticks = std::lround(leg.norm() / one.feed / kTick) * std::lround(kTick / tick);
        for (long k = 0; k < ticks; ++k)
            add(one.corners[i - 1] + static_cast<double>(k) / static_cast<double>(ticks) * leg);
    }
    for (long k = 0; k <= std::lround(kRest / tick); ++k) add(one.corners.back());
    return path;
}

CutOutcome cutOut(const HeldBack& one, double tick) {
    const TriangleMesh bur =
        one.isBall ? test::sphere(Vec3(0, 0, kRadius), kRadius, 48, 24) : test::cylinder(Vec3::Zero(), kRadius, 4, 64);
    const auto piece = std::make_shared<CutModel>(std::make_shared<const LayeredTooth>(std::move(*LayeredTooth::make(
                                                      test::box(Vec3(-2, -2, -2), Vec3(2, 2, 0)), {}, one.material))),
                                                  kVoxel);
    const CuttingTool tool{*RevolutionEnvelope::make(bur), 1};
    HapticSettings settings;
    settings.spindle = constantSpeed(kSpeed);
    StepwiseSession session(piece, cutSetup({std::make_shared<const ToolShape>(bur), tool}, settings));
    double behind = 0;
    EXPECT_TRUE(cutWithRemovalLaw(pathOf(one, tick), session, [&](double, const Tick& now, const ToothLoss&) {
        behind = std::max(behind, now.contact.depth);
    }));
    EXPECT_GT(behind, 0.01) << "the hand is ahead of its bur";
    return CutOutcome(*piece);
}

class LimitedFeed : public testing::TestWithParam<HeldBack> {};

TEST_P(LimitedFeed, LeavesTheSameAtOneAndFourKilohertz) {
    const CutOutcome fine = cutOut(GetParam(), kTick / 4);
    const CutOutcome coarse = cutOut(GetParam(), kTick);
    test::expectSame(fine, coarse);
    RecordProperty("apartPpm", static_cast<int>(1e6 * (coarse.removed / fine.removed - 1)));
    RecordProperty("apartNanometres", static_cast<int>(1e6 * hausdorffDistance(fine.surface, coarse.surface)));
}

INSTANTIATE_TEST_SUITE_P(All, LimitedFeed, testing::ValuesIn(all()), [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace tactooth
