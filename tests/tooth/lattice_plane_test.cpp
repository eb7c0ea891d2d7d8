// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Flat walls at special numbers: on planes of the lattice's nodes, on round multiples of the spacing, and through zero.
// There the same point, computed in two ways, may differ after rounding to a float.
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "geometry/io/stl_reader.h"
#include "geometry/io/stl_writer.h"
#include "geometry/mesh/mesh_report.h"
#include "geometry/util/pose.h"
#include "support/materials.h"
#include "support/sanitizer.h"
#include "support/shapes.h"
#include "tooth/file/remaining_layers.h"
#include "tooth/surface/incremental_surface.h"

namespace tactooth {
namespace {

constexpr double kRadius = 0.5;
constexpr double kBlock = 1.713;  ///< half the side of the block, mm; not a round number of any lattice below

RevolutionEnvelope flatBur() { return *RevolutionEnvelope::make(test::cylinder(Vec3::Zero(), kRadius, 4, 64)); }

/// A slot in a cubic block. A flat bur goes in along -`inward` * `axis` until its end stands at `floor`. Then it moves
/// across, from `from` to `to` on the next axis. Its sides are at `side` and 2 * kRadius above that on the third axis.
struct Slot {
    int axis;
    int inward;  ///< -1: from above; 1: from below
    double floor;
    double from, to;
    double side;

    [[nodiscard]] Pose pose(double height, double along) const {
        Vec3 tip;
        tip[axis] = height;
        tip[(axis + 1) % 3] = along;
        tip[(axis + 2) % 3] = side + kRadius;
        return {tip, shortestRotation(Vec3::UnitZ(), -inward * Vec3::Unit(axis))};
    }
    [[nodiscard]] double volume() const {
        const double depth = kBlock + inward * floor;
        return depth * (std::numbers::pi * kRadius * kRadius + 2 * kRadius * std::abs(to - from));
    }
};

struct Piece {
    explicit Piece(TriangleMesh outer, double voxel, const std::vector<LayerMesh>& layers = {})
        : volume(std::make_shared<const LayeredTooth>(std::move(*LayeredTooth::make(std::move(outer), layers))), voxel),
          surface(volume) {}

    void move(const Pose& from, const Pose& to, int steps) {
        const RevolutionEnvelope bur = flatBur();
        for (int i = 0; i < steps; ++i) {
            const auto at = [&](int k) {
                const double t = static_cast<double>(k) / steps;
                return Pose{k == steps ? to.position : Vec3(from.position + t * (to.position - from.position)),
                            from.rotation};
            };
            const CarveResult result = volume.carve(bur, at(i), at(i + 1), 0);
            surface.update(volume, result.changed);
        }
    }
    void mill(const Slot& slot, int steps) {
        move(slot.pose(-slot.inward * (kBlock + 0.1), slot.from), slot.pose(slot.floor, slot.from), steps);
        move(slot.pose(slot.floor, slot.from), slot.pose(slot.floor, slot.to), steps);
    }

    CutVolume volume;
    IncrementalSurface surface;
};

/// The report on the mesh as a reader of the file sees it: equal points are one.
MeshReport reportOnFileOf(const TriangleMesh& mesh) { return reportOn(*parseStl(stlBytes(mesh), "cut")); }

void expectSound(const MeshReport& report) {
    EXPECT_TRUE(report.watertight()) << report.boundaryEdges << " open, " << report.nonManifoldEdges << " crowded, "
                                     << report.inconsistentEdges << " turned edges";
    EXPECT_EQ(report.duplicateTriangles, 0U);
    EXPECT_EQ(report.pinchedVertices, 0U);
    EXPECT_EQ(report.shells.size(), 1U);
}

TriangleMesh block() { return test::box(Vec3::Constant(-kBlock), Vec3::Constant(kBlock)); }

void expectExactSlot(const Slot& slot, double voxel, int steps) {
    Piece piece(block(), voxel);
    piece.mill(slot, steps);
    const MeshReport report = reportOnFileOf(visibleMesh(*piece.surface.snapshot()).mesh);
    expectSound(report);
    EXPECT_EQ(piece.surface.failures(), 0U);
    const double lost = 8 * kBlock * kBlock * kBlock - report.signedVolume;
    EXPECT_NEAR(lost, slot.volume(), 0.005 * slot.volume());
}

/// The coordinate of the plane of nodes `i` on `axis`.
double nodePlane(double voxel, int axis, int i) { return Lattice(voxel).node(i, i, i)[axis]; }

TEST(LatticePlane, AFlatBurThatStopsAtZeroLeavesAClosedSurface) {
    for (const double voxel : {0.1, 0.07, 0.05, 0.025}) {
        if (voxel < test::cases(0.0, 0.06)) continue;
        for (int axis = 0; axis < 3; ++axis) {
            for (const int inward : {-1, 1}) {
                SCOPED_TRACE(testing::Message() << "voxel " << voxel << " axis " << axis << " inward " << inward);
                expectExactSlot({axis, inward, 0, -0.6, 0.5, -0.5}, voxel, 3);
            }
        }
    }
}

TEST(LatticePlane, ASideOfTheBurThatPassesAlongZeroLeavesAClosedSurface) {
    for (int axis = 0; axis < 3; ++axis) {
        SCOPED_TRACE(axis);
        expectExactSlot({axis, -1, 0.31, -0.6, 0.5, 0}, 0.1, 4);
        expectExactSlot({axis, 1, -0.31, 0, 0.5, -2 * kRadius}, 0.05, 4);
    }
}

TEST(LatticePlane, FloorAndSidesOnNodesLeaveAClosedSurface) {
    for (const double voxel : {0.1, 0.05}) {
        if (voxel < test::cases(0.0, 0.06)) continue;
        for (int axis = 0; axis < 3; ++axis) {
            for (const int node : {-8, -1, 0, 3}) {  // the first one begins a brick, the second one ends a brick
                SCOPED_TRACE(testing::Message() << "voxel " << voxel << " axis " << axis << " node " << node);
                const double floor = nodePlane(voxel, axis, node);
                const double side = nodePlane(voxel, (axis + 2) % 3, node);
                expectExactSlot({axis, node % 2 == 0 ? 1 : -1, floor, -0.5, 0.4, side}, voxel, 2);
            }
        }
    }
}

TEST(LatticePlane, RandomMultiplesOfTheVoxelLeaveAClosedSurface) {
    std::mt19937 random(20261122);
    std::uniform_int_distribution<int> whole(-6, 6);
    int onNodes = 0;
    constexpr int kSlots = test::cases(60, 10);
    for (int i = 0; i < kSlots; ++i) {
        const double voxel = std::array{0.1, 0.08, 0.05}[random() % 3];
        const int axis = static_cast<int>(random() % 3);
        const bool nodes = random() % 2 == 0;
        onNodes += nodes ? 1 : 0;
        const auto place = [&](int onAxis) {
            const int k = whole(random);
            return nodes ? nodePlane(voxel, onAxis, k) : voxel * k;
        };
        const double floor = place(axis);
        const double from = place((axis + 1) % 3);
        const double side = place((axis + 2) % 3) - (random() % 2 == 0 ? 2 * kRadius : 0);
        const Slot slot{axis, random() % 2 == 0 ? 1 : -1, floor, from, from + voxel * whole(random), side};
        SCOPED_TRACE(testing::Message() << "slot " << i << " voxel " << voxel << " axis " << axis << " floor "
                                        << floor);
        expectExactSlot(slot, voxel, 1 + static_cast<int>(random() % 4));
    }
    EXPECT_GT(onNodes, kSlots * 3 / 10);
    EXPECT_LT(onNodes, kSlots * 7 / 10);
}

TEST(LatticePlane, LayersCutAtZeroAreClosedOneByOne) {
    const std::vector<LayerMesh> layers = {
        {"enamel", test::kEnamel, test::box(Vec3::Constant(-kBlock), Vec3::Constant(kBlock))},
        {"dentin", test::kDentin, test::box(Vec3::Constant(-1.3), Vec3::Constant(1.3))}};
    Piece piece(block(), 0.1, layers);
    const Slot slot{2, -1, 0, -0.5, 0.5, 0};
    piece.mill(slot, 3);
    expectSound(reportOnFileOf(visibleMesh(*piece.surface.snapshot()).mesh));
    double lost = 0;
    for (const RemainingLayer& remains : remainingLayers(piece.volume)) {
        const MeshReport report = reportOnFileOf(remains.mesh);
        EXPECT_TRUE(report.watertight()) << remains.name;
        EXPECT_EQ(report.duplicateTriangles, 0U) << remains.name;
        EXPECT_EQ(report.pinchedVertices, 0U) << remains.name;
        if (remains.name == "dentin") lost = 8 * 1.3 * 1.3 * 1.3 - report.signedVolume;
    }
    const double dentin = slot.volume() * 1.3 / kBlock;
    EXPECT_NEAR(lost, dentin, 0.005 * dentin);
}

TEST(LatticePlane, AWallOnTheBlocksOwnFaceLeavesAClosedSurface) {
    for (const double half : {1.0, 1.5}) {
        for (int axis = 0; axis < 3; ++axis) {
            for (const int inward : {-1, 1}) {
                SCOPED_TRACE(testing::Message() << "half " << half << " axis " << axis << " inward " << inward);
                Piece through(test::box(Vec3::Constant(-half), Vec3::Constant(half)), 0.1);
                through.mill({axis, inward, inward * half, -0.3, 0.2, -0.4}, 3);
                expectSound(reportOnFileOf(visibleMesh(*through.surface.snapshot()).mesh));
                EXPECT_EQ(through.surface.failures(), 0U);
                Piece beside(test::box(Vec3::Constant(-half), Vec3::Constant(half)), 0.1);
                beside.mill({axis, inward, 0.3 * inward, -0.3, 0.2, half - 2 * kRadius}, 3);
                expectSound(reportOnFileOf(visibleMesh(*beside.surface.snapshot()).mesh));
                EXPECT_EQ(beside.surface.failures(), 0U);
            }
        }
    }
}

}  // namespace
}  // namespace tactooth
