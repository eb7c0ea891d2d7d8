// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/volume/cut_volume.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "support/expect_assert.h"
#include "support/materials.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

constexpr double kVoxel = 0.05;
constexpr double kPi = std::numbers::pi;

std::shared_ptr<const LayeredTooth> block(std::vector<LayerMesh> layers = {}) {
    auto tooth = LayeredTooth::make(test::box(Vec3(-2, -2, -3), Vec3(2, 2, 0)), std::move(layers));
    return std::make_shared<const LayeredTooth>(std::move(*tooth));
}

RevolutionEnvelope envelopeOf(const TriangleMesh& bur) { return *RevolutionEnvelope::make(bur); }
RevolutionEnvelope flatBur(double radius) { return envelopeOf(test::cylinder(Vec3::Zero(), radius, 4, 128)); }

Pose at(double x, double y, double z) { return {Vec3(x, y, z), Quat::Identity()}; }
Pose leaning(const Vec3& tip, double angle) { return {tip, Quat(Eigen::AngleAxisd(angle, Vec3::UnitX()))}; }

/// A path with a plunge, a slot and a tilt. Each leg has `parts` moves.
MaterialVolumes carvePath(CutVolume& volume, const RevolutionEnvelope& bur, int parts) {
    const std::vector<Pose> legs = {at(0, 0, 0.5), at(0, 0, -1), at(0.6, 0.2, -1), leaning(Vec3(0.6, 0.2, -1), 0.3)};
    MaterialVolumes removed{};
    for (std::size_t leg = 0; leg + 1 < legs.size(); ++leg) {
        const auto point = [&](int i) {
            const double t = static_cast<double>(i) / parts;
            return Pose{(1 - t) * legs[leg].position + t * legs[leg + 1].position,
                        legs[leg].rotation.slerp(t, legs[leg + 1].rotation)};
        };
        for (int i = 0; i < parts; ++i) {
            const CarveResult step = volume.carve(bur, point(i), point(i + 1), 0);
            for (std::size_t m = 0; m < kMaxMaterials; ++m) removed[m] += step.removed[m];
        }
    }
    return removed;
}

TEST(CutVolume, StraightHoleByAFlatBur) {
    CutVolume volume(block(), kVoxel);
    const auto removed = volume.carve(flatBur(0.6), at(0.01, 0.02, 0.5), at(0.01, 0.02, -1.5), 0).removed;
    EXPECT_NEAR(total(removed), kPi * 0.36 * 1.5, 0.005 * kPi * 0.36 * 1.5);
}

TEST(CutVolume, SlotByAFlatBur) {
    CutVolume volume(block(), kVoxel);
    const auto bur = flatBur(0.5);
    double removed = total(volume.carve(bur, at(-0.5, 0, 0.5), at(-0.5, 0, -0.8), 0).removed);
    removed += total(volume.carve(bur, at(-0.5, 0, -0.8), at(0.7, 0.3, -0.8), 0).removed);
    const double expected = 0.8 * (kPi * 0.25 + 2 * 0.5 * std::hypot(1.2, 0.3));
    EXPECT_NEAR(removed, expected, 0.005 * expected);
}

TEST(CutVolume, BowlByABall) {
    CutVolume volume(block(), kVoxel);
    const auto ball = envelopeOf(test::sphere(Vec3(0, 0, 0.5), 0.5, 256, 128));
    const double removed = total(volume.carve(ball, at(0, 0, 0.1), at(0, 0, -0.4), 0).removed);
    const double expected = kPi * 0.4 * 0.4 * (0.5 - 0.4 / 3);
    EXPECT_NEAR(removed, expected, 0.01 * expected);
}

TEST(CutVolume, ClearanceWidensTheHole) {
    CutVolume volume(block(), kVoxel);
    const double removed = total(volume.carve(flatBur(0.6), at(0, 0, 0.5), at(0, 0, -1.5), 0.02).removed);
    const double expected = kPi * 0.62 * 0.62 * 1.52;
    EXPECT_NEAR(removed, expected, 0.005 * expected);
}

TEST(CutVolume, EachMaterialIsCountedWhereItLies) {
    const auto tooth = block({{"enamel", test::kEnamel, test::box(Vec3(-2, -2, -0.5), Vec3(2, 2, 0))},
                              {"dentin", test::kDentin, test::box(Vec3(-2, -2, -3), Vec3(2, 2, -0.5))}});
    CutVolume volume(tooth, kVoxel);
    const auto removed = volume.carve(flatBur(0.6), at(0, 0, 0.5), at(0, 0, -1.5), 0).removed;
    const double area = kPi * 0.36;
    EXPECT_NEAR(removed[static_cast<std::size_t>(test::kEnamel)], 0.5 * area, 0.5 * kVoxel * area);
    EXPECT_NEAR(removed[static_cast<std::size_t>(test::kDentin)], 1.0 * area, 0.5 * kVoxel * area);
    EXPECT_EQ(removed[static_cast<std::size_t>(test::kPulp)], 0);
}

TEST(CutVolume, TheSumOverStepsIsTheVolumeOfTheCavity) {
    CutVolume volume(block(), kVoxel);
    const double summed = total(carvePath(volume, flatBur(0.4), 25));
    EXPECT_NEAR(summed, total(volume.removedVolume()), 1e-9);
    EXPECT_GT(summed, 0.5);
}

TEST(CutVolume, FinerStepsRemoveTheSame) {
    CutVolume coarse(block(), kVoxel);
    CutVolume fine(block(), kVoxel);
    const double few = total(carvePath(coarse, flatBur(0.4), 10));
    const double many = total(carvePath(fine, flatBur(0.4), 40));
    EXPECT_NEAR(few, many, 0.002 * many);
}

TEST(CutVolume, TheOrderOfCutsDoesNotMatter) {
    CutVolume forward(block(), kVoxel);
    CutVolume backward(block(), kVoxel);
    const auto bur = flatBur(0.4);
    const double first = total(forward.carve(bur, at(0, 0, 0.1), at(0, 0, -1), 0).removed) +
                         total(forward.carve(bur, at(0.3, 0, -0.5), at(0.6, 0, -0.5), 0).removed);
    const double second = total(backward.carve(bur, at(0.3, 0, -0.5), at(0.6, 0, -0.5), 0).removed) +
                          total(backward.carve(bur, at(0, 0, 0.1), at(0, 0, -1), 0).removed);
    EXPECT_NEAR(first, second, 1e-6);
}

TEST(CutVolume, APlanPredictsTheCarveAndChangesNothing) {
    CutVolume volume(block(), kVoxel);
    const auto bur = flatBur(0.4);
    volume.carve(bur, at(0, 0, 0.5), at(0, 0, -0.5));
    const std::uint64_t before = volume.hash();
    const double planned = total(volume.removable(bur, at(0, 0, -0.5), at(0.02, 0, -0.53)).volumes);
    EXPECT_EQ(volume.hash(), before);
    EXPECT_EQ(total(volume.carve(bur, at(0, 0, -0.5), at(0.02, 0, -0.53)).removed), planned);
    EXPECT_GT(planned, 0);
    EXPECT_EQ(total(volume.removable(bur, at(0, 0, -0.5), at(0.02, 0, -0.53)).volumes), 0);
}

/// The largest difference of the cut fields of two volumes, mm.
double largestDifference(const CutVolume& one, const CutVolume& other) {
    double largest = 0;
    for (const BrickKey& key : one.bricks().keys()) {
        for (int node = 0; node < kBrickNodes; ++node) {
            const double difference = one.bricks().find(key)->cut[node] - other.bricks().find(key)->cut[node];
            largest = std::max(largest, std::abs(difference));
        }
    }
    return largest;
}

TEST(CutVolume, APartOfThePathIsPlannedFromTheNodesOfTheWhole) {
    const auto bur = flatBur(0.4);
    const auto start = at(0, 0, -0.5);
    for (const double part : {0.003, 0.1, 0.35, 0.6, 1.0}) {
        const Pose end = at(0.2 * part, 0, -0.5 - 0.2 * part);
        CutVolume volume(block(), kVoxel);
        CutVolume other(block(), kVoxel);
        for (CutVolume* one : {&volume, &other}) one->carve(bur, at(0, 0, 0.5), start);
        const PlannedRemoval whole = volume.removable(bur, start, at(0.2, 0, -0.7));
        const PlannedRemoval planned = volume.removableUpTo(whole, bur, start, end);
        (void)other.removable(bur, start, at(0.2, 0, -0.7));  // makes the same bricks
        const double alone = total(other.carve(bur, start, end).removed);
        EXPECT_GT(alone, 0) << part;
        EXPECT_NEAR(total(planned.volumes), alone, 1e-6 * alone) << part;
        EXPECT_EQ(volume.carve(planned).removed, planned.volumes) << part;
        // A node that the whole path lowers by less than kLeastChange is left out.
        EXPECT_LT(largestDifference(volume, other), 4e-5) << part;
    }
}

TEST(CutVolume, OneThreadAndManyGiveTheSameBits) {
    CutVolume many(block(), kVoxel);
    const MaterialVolumes removedByMany = carvePath(many, flatBur(0.4), 10);
    const tbb::global_control single(tbb::global_control::max_allowed_parallelism, 1);
    CutVolume one(block(), kVoxel);
    EXPECT_EQ(carvePath(one, flatBur(0.4), 10), removedByMany);
    EXPECT_EQ(one.hash(), many.hash());
}

TEST(CutVolume, RemovedNodesAreThoseWithANegativeDistance) {
    CutVolume volume(block(), kVoxel);
    carvePath(volume, flatBur(0.4), 2);
    volume.mark();
    volume.carve(flatBur(0.4), at(-1, -1, 0.5), at(-1, -1, -2));
    (void)volume.undo();
    volume.carve(flatBur(0.4), at(1, -1, 0.5), at(1, -1, -2));
    std::size_t removed = 0;
    for (const BrickKey& key : volume.bricks().keys()) {
        const Brick& brick = *volume.bricks().find(key);
        for (int node = 0; node < kBrickNodes; ++node) {
            const auto [x, y, z] = placeOf(node);
            ASSERT_EQ(brick.removedRow(y, z) >> x & 1U, brick.cut[node] < 0 ? 1U : 0U);
            removed += brick.cut[node] < 0;
        }
    }
    EXPECT_GT(removed, 1000U);
}

/// Counts the unknown bricks that have a node in a cell with a removed node.
std::size_t unknownBesideTheWall(const CutVolume& volume) {
    std::size_t unknown = 0;
    for (const BrickKey& key : volume.bricks().keys()) {
        for (int node = 0; node < kBrickNodes; ++node) {
            if (!volume.bricks().find(key)->removed[node]) continue;
            const auto [x, y, z] = placeOf(node);
            const Eigen::Vector3i number = kBrickSide * Eigen::Vector3i(key.x, key.y, key.z) + Eigen::Vector3i(x, y, z);
            for (int i = 0; i < 27; ++i) {
                const Eigen::Vector3i beside = number + Eigen::Vector3i(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
                unknown += !volume.bricks().knows(LatticeNode(beside).key);
            }
        }
    }
    return unknown;
}

// A wall that ends in the corner of a brick needs nodes of the next brick, which no bur was near.
TEST(CutVolume, EachNodeOfACellWithARemovedOneIsKnown) {
    constexpr double kHead = 0.015;  // mm; one node fits in, and only the next ones on each axis are in reach
    CutVolume volume(block(), kVoxel);
    const Vec3 first = volume.lattice().corner({0, 0, -4});
    const auto bur = envelopeOf(test::sphere(Vec3(0, 0, kHead), kHead, 16, 8));
    const Pose there{first - kHead * Vec3::UnitZ(), Quat::Identity()};
    EXPECT_GT(total(volume.carve(bur, there, there, 0).removed), 0);
    EXPECT_TRUE(volume.bricks().find({0, 0, -4})->removed[0]);
    EXPECT_EQ(unknownBesideTheWall(volume), 0U);

    std::map<BrickKey, CutField> fields;
    for (const BrickKey& key : volume.cutBricks()) fields[key] = *volume.bricks().find(key);
    CutVolume again(block(), kVoxel);
    EXPECT_FALSE(again.adopt(fields).empty());
    EXPECT_EQ(again.hash(), volume.hash());
    EXPECT_EQ(unknownBesideTheWall(again), 0U);
}

TEST(CutVolume, ABurInTheAirChangesNothing) {
    CutVolume volume(block(), kVoxel);
    const auto result = volume.carve(flatBur(0.4), at(0, 0, 0.5), at(1, 0, 0.5));
    EXPECT_EQ(total(result.removed), 0);
    EXPECT_TRUE(result.changed.empty());
}

TEST(CutVolume, ResetBringsBackTheWholeTooth) {
    CutVolume volume(block(), kVoxel);
    const auto cut = [&] { return total(volume.carve(flatBur(0.4), at(0, 0, 0.5), at(0, 0, -0.5)).removed); };
    const double first = cut();
    EXPECT_EQ(cut(), 0);
    volume.reset();
    EXPECT_EQ(total(volume.removedVolume()), 0);
    EXPECT_EQ(cut(), first);
}

TEST(CutVolumeAsserts, AToothAndAClearanceAreGiven) {
    EXPECT_ASSERT(CutVolume(nullptr, kVoxel));
    CutVolume volume(block(), kVoxel);
    EXPECT_ASSERT(volume.carve(flatBur(0.4), at(0, 0, 0.5), at(0, 0, -0.5), -0.01));
    EXPECT_ASSERT(static_cast<void>(volume.cutDistance(Vec3(0, 0, std::nan("")))));
}

TEST(CutVolumeAsserts, APlanHoldsUntilTheNextCut) {
    CutVolume volume(block(), kVoxel);
    const auto bur = flatBur(0.4);
    const PlannedRemoval planned = volume.removable(bur, at(0, 0, 0.5), at(0, 0, -0.5));
    (void)volume.carve(planned);
    EXPECT_ASSERT(volume.carve(planned));
    EXPECT_ASSERT(static_cast<void>(volume.removableUpTo(planned, bur, at(0, 0, 0.5), at(0, 0, 0))));
}

TEST(CutVolumeAsserts, WithoutAMarkNothingIsUndone) {
    CutVolume volume(block(), kVoxel);
    EXPECT_ASSERT(static_cast<void>(volume.undo()));
}

TEST(CutVolumeAsserts, AVolumeThatIsCutAdoptsNothing) {
    CutVolume volume(block(), kVoxel);
    volume.carve(flatBur(0.4), at(0, 0, 0.5), at(0, 0, -0.5));
    EXPECT_ASSERT(static_cast<void>(volume.adopt({})));
}

}  // namespace
}  // namespace tactooth
