// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/volume/bur_feed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/expect_assert.h"
#include "support/materials.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

constexpr double kVoxel = 0.05;
constexpr double kRadius = 0.5;
constexpr double kArea = std::numbers::pi * kRadius * kRadius;

CutVolume blockOf(MaterialId material) {
    auto tooth = LayeredTooth::make(test::box(Vec3(-2, -2, -3), Vec3(2, 2, 0)), {}, material);
    return {std::make_shared<const LayeredTooth>(std::move(*tooth)), kVoxel};
}

RevolutionEnvelope flatBur() { return *RevolutionEnvelope::make(test::cylinder(Vec3::Zero(), kRadius, 4, 128)); }

Pose atDepth(double depth) { return {Vec3(0.01, 0.02, -depth), Quat::Identity()}; }

/// Pushes a flat bur from the surface toward a depth of 0.5 mm.
FeedResult push(CutVolume& volume, double work, double sharpness = 1) {
    return feedBur(volume, flatBur(), atDepth(0), atDepth(0.5), work, {}, sharpness);
}

TEST(WorkFor, AddsUpWhatEachMaterialAsksFor) {
    const MaterialTable table;
    MaterialVolumes volumes{};
    volumes[static_cast<std::size_t>(test::kEnamel)] = 0.2;
    volumes[static_cast<std::size_t>(test::kCaries)] = 0.3;
    const double expected = 0.2 / table[test::kEnamel].removal + 0.3 / table[test::kCaries].removal;
    EXPECT_DOUBLE_EQ(workFor(volumes, table, 1), expected);
    EXPECT_DOUBLE_EQ(workFor(volumes, table, 0.25), 4 * expected);
}

TEST(WorkFor, NothingCostsNothingAndABurWithoutEdgeCannotPay) {
    MaterialVolumes volumes{};
    EXPECT_EQ(workFor(volumes, {}, 1), 0);
    EXPECT_EQ(workFor(volumes, {}, 0), 0);
    volumes[0] = 1e-9;
    EXPECT_TRUE(std::isinf(workFor(volumes, {}, 0)));
}

TEST(Between, EndsExactlyAtBothPosesAndIsHalfWayInTheMiddle) {
    const Pose from{Vec3(1, 2, 3), Quat::Identity()};
    const Pose to{Vec3(2, 4, 7), Quat(Eigen::AngleAxisd(1.0, Vec3::UnitY()))};
    EXPECT_EQ(between(from, to, 0).position, from.position);
    EXPECT_EQ(between(from, to, 1).position, to.position);
    EXPECT_EQ(between(from, to, 1).rotation.coeffs(), to.rotation.coeffs());
    const Pose middle = between(from, to, 0.5);
    EXPECT_TRUE(middle.position.isApprox(Vec3(1.5, 3, 5), 1e-15));
    EXPECT_NEAR(middle.rotation.angularDistance(from.rotation), 0.5, 1e-12);
}

TEST(BurFeed, SpendsTheWorkAndNeverMore) {
    for (const double work : {1.0, 5.0, 20.0}) {
        CutVolume volume = blockOf(test::kEnamel);
        const FeedResult result = push(volume, work);
        EXPECT_LE(result.work, work);
        EXPECT_GE(result.work, 0.97 * work);
        EXPECT_NEAR(workFor(result.carve.removed, {}, 1), result.work, 1e-12 * work);
    }
}

TEST(BurFeed, AnEstimateOfTheFractionHardlyChangesTheCut) {
    for (const double work : {1.0, 5.0, 20.0, 1e3}) {
        CutVolume volume = blockOf(test::kEnamel);
        const FeedResult whole = push(volume, work);
        for (const double enough : {1e-3, 0.05, 0.3, 2.0}) {
            CutVolume other = blockOf(test::kEnamel);
            const FeedResult result = feedBur(other, flatBur(), atDepth(0), atDepth(0.5), work, {}, 1, enough);
            EXPECT_LE(result.work, work) << enough;
            EXPECT_GE(result.work, std::min(0.97 * work, whole.work)) << enough;
            EXPECT_NEAR(result.fraction, whole.fraction, 0.04 * whole.fraction) << enough;
        }
    }
}

TEST(BurFeed, ReturnsTheWorkThatAStepRequiresIfThereIsLess) {
    CutVolume volume = blockOf(test::kEnamel);
    const double hair = 1e-9;
    const FeedResult result = push(volume, hair);
    EXPECT_EQ(result.fraction, 0);
    EXPECT_EQ(result.work, 0);
    EXPECT_GT(result.requiredWork, hair);
    const FeedResult enough = push(volume, 1.05 * result.requiredWork);
    EXPECT_GT(enough.fraction, 0);
    EXPECT_LE(enough.work, 1.05 * result.requiredWork);
}

/// The work that the hole of a bur at that depth requires, with its clearance, N*m, if the block was whole before.
double workInPlace(double depth) {
    CutVolume volume = blockOf(test::kEnamel);
    return workFor(volume.removable(flatBur(), atDepth(depth), atDepth(depth)).volumes, {}, 1);
}

FeedResult goDeeper(CutVolume& volume, double work) {
    return feedBur(volume, flatBur(), atDepth(0.2), atDepth(0.5), work, {}, 1);
}

TEST(BurFeed, ABurAtANewPlaceFirstCutsTheClearanceAroundIt) {
    const double required = workInPlace(0.2);
    for (const double share : {1e-6, 0.5, 0.999}) {
        CutVolume volume = blockOf(test::kEnamel);
        const std::uint64_t whole = volume.hash();
        const FeedResult result = goDeeper(volume, share * required);
        EXPECT_EQ(result.fraction, 0) << share;
        EXPECT_NEAR(result.requiredWork, required, 1e-9 * required) << share;
        EXPECT_EQ(volume.hash(), whole) << share;
    }
    for (const double share : {1.001, 1.02, 1.1, 1.5, 2.0}) {
        CutVolume volume = blockOf(test::kEnamel);
        const FeedResult result = goDeeper(volume, share * required);
        EXPECT_LE(result.work, share * required) << share;
        EXPECT_GE(result.work, 0.97 * share * required) << share;
    }
}

TEST(BurFeed, AfterTheClearanceIsCutOnlyTheStepRequiresWork) {
    CutVolume volume = blockOf(test::kEnamel);
    const double required = workInPlace(0.2);
    const FeedResult first = goDeeper(volume, 1.0001 * required);
    EXPECT_EQ(first.fraction, 0);
    EXPECT_NEAR(first.work, required, 1e-9 * required);
    EXPECT_EQ(first.requiredWork, 0) << "no short step was tried";
    const FeedResult second = goDeeper(volume, 0.1 * required);
    EXPECT_GT(second.fraction, 0);
    EXPECT_GE(second.work, 0.097 * required);
}

TEST(BurFeed, TheDepthIsTheWorkTimesRemovalOverTheArea) {
    CutVolume volume = blockOf(test::kDentin);
    const FeedResult result = push(volume, 10);
    const double clearance = kDefaultClearance * kVoxel;
    const double depth = 10 * MaterialTable{}[test::kDentin].removal / kArea - clearance;
    EXPECT_NEAR(0.5 * result.fraction, depth, 0.04 * depth);
}

TEST(BurFeed, EqualWorkTakesMaterialsInTheRatioOfTheirRemoval) {
    const auto removedFrom = [](MaterialId material) {
        CutVolume volume = blockOf(material);
        return total(push(volume, 3).carve.removed);
    };
    const MaterialTable table;
    const double enamel = removedFrom(test::kEnamel) / table[test::kEnamel].removal;
    for (const MaterialId other : {test::kDentin, test::kCaries}) {
        EXPECT_NEAR(removedFrom(other) / table[other].removal, enamel, 0.05 * enamel);
    }
}

TEST(BurFeed, AWornBurCutsInProportionToItsSharpness) {
    CutVolume sharp = blockOf(test::kEnamel);
    CutVolume worn = blockOf(test::kEnamel);
    EXPECT_NEAR(total(push(worn, 10, 0.5).carve.removed), 0.5 * total(push(sharp, 10).carve.removed), 0.003);
}

TEST(BurFeed, CutsTheWholePathWhereTheWorkSuffices) {
    CutVolume volume = blockOf(test::kCaries);
    const FeedResult result = push(volume, 1e6);
    EXPECT_EQ(result.fraction, 1);
    const double clearance = kDefaultClearance * kVoxel;
    const double hole = std::numbers::pi * std::pow(kRadius + clearance, 2) * (0.5 + clearance);
    EXPECT_NEAR(total(result.carve.removed), hole, 0.005 * hole);
    EXPECT_LT(result.work, 10);
}

TEST(BurFeed, WithoutWorkOrEdgeNothingChanges) {
    CutVolume volume = blockOf(test::kEnamel);
    const std::uint64_t whole = volume.hash();
    EXPECT_EQ(push(volume, 0).work, 0);
    const FeedResult blunt = push(volume, 100, 0);
    EXPECT_EQ(total(blunt.carve.removed), 0);
    EXPECT_EQ(volume.hash(), whole);
    EXPECT_EQ(total(volume.removedVolume()), 0);
}

TEST(BurFeed, InTheAirItCostsNothing) {
    CutVolume volume = blockOf(test::kEnamel);
    const FeedResult result = feedBur(volume, flatBur(), atDepth(-1), atDepth(-0.5), 0, {}, 1);
    EXPECT_EQ(result.fraction, 1);
    EXPECT_EQ(result.work, 0);
    EXPECT_TRUE(result.carve.changed.empty());
}

TEST(BurFeedAsserts, WorkAndSharpnessAreNotNegativeAndNumbers) {
    CutVolume volume = blockOf(test::kEnamel);
    EXPECT_ASSERT(push(volume, -1));
    EXPECT_ASSERT(static_cast<void>(workFor({}, {}, std::nan(""))));
    EXPECT_ASSERT(static_cast<void>(between(atDepth(0), atDepth(1), -0.5)));
}

}  // namespace
}  // namespace tactooth
