// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/surface/wall_vertices.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "support/shapes.h"
#include "tooth/surface/cell_topology.h"
#include "tooth/surface/wall_loops.h"
#include "tooth/volume/cut_volume.h"

namespace tactooth {
namespace {

constexpr double kVoxel = 0.1;
constexpr double kRounding = 1e-6;  // voxels

/// A block that a flat fissure bur has crossed at random angles: sharp edges, thin ridges and gaps.
CutVolume cutBlock(unsigned seed) {
    auto block = LayeredTooth::make(test::box(Vec3(-1, -1, -1), Vec3(1, 1, 1)));
    CutVolume volume(std::make_shared<const LayeredTooth>(std::move(*block)), kVoxel);
    const RevolutionEnvelope bur = *RevolutionEnvelope::make(test::cylinder(Vec3::Zero(), 0.2, 4, 32));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto vector = [&] { return Vec3(unit(random), unit(random), unit(random)); };
    for (int stroke = 0; stroke < 30; ++stroke) {
        const Quat lean = Quat::FromTwoVectors(Vec3::UnitZ(), vector());
        (void)volume.carve(bur, {vector(), lean}, {vector(), lean}, 0);
    }
    return volume;
}

/// From its first node, in voxels.
Vec3 placeIn(int cell, const Vec3& point, const NodePoints& points) {
    return (point - points.point(cell)) / points.spacing();
}

bool isWithin(const Vec3& place) { return place.minCoeff() >= -kRounding && place.maxCoeff() <= 1 + kRounding; }

class EachBrick : public ::testing::Test {
protected:
    /// Calls `check(nodes, points, polygons)` for each brick with a wall.
    template <class Check>
    void forEachBrick(const Check& check) {
        for (unsigned seed = 1; seed <= 5; ++seed) {
            const CutVolume volume = cutBlock(seed);
            for (const BrickKey& key : volume.cutBricks()) {
                const BrickNeighbourhood nodes(volume.bricks(), key, kVoxel);
                WallPolygons found(nodes, kVoxel);
                if (!found.polygons().empty()) check(nodes, NodePoints(volume.lattice(), key), found);
            }
        }
    }
};

TEST_F(EachBrick, HasItsVerticesWithinTheirCells) {
    int simple = 0;
    forEachBrick([&](const BrickNeighbourhood& nodes, const NodePoints& points, WallPolygons& found) {
        const WallVertices vertices(nodes, found.cells());
        for (std::size_t i = 0; i < found.cells().size(); ++i) {
            if (!kCellCrossings[nodes.removedCorners(found.cells()[i])].isSimple) continue;
            const Vec3 place = placeIn(found.cells()[i], vertices.point(i, points), points);
            EXPECT_TRUE(isWithin(place)) << place.transpose();
            ++simple;
        }
    });
    EXPECT_GT(simple, 10000);
}

/// The mean of the points where the boundary crosses the edges of a cell, from its first node, in voxels.
Vec3 meanCrossing(const BrickNeighbourhood& nodes, int cell) {
    const CellCrossings& crossings = kCellCrossings[nodes.removedCorners(cell)];
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < crossings.count; ++i) {
        const int axis = crossings.edges[i] / 4;
        const int corner = cellEdgeCorners(crossings.edges[i])[0];
        const Vec3 first(corner & 1, corner >> 1 & 1, corner >> 2);
        const int step =
            BrickNeighbourhood::index(corner & 1, corner >> 1 & 1, corner >> 2) - BrickNeighbourhood::index(0, 0, 0);
        sum += first + nodes.boundary(cell + step, axis).place * Vec3::Unit(axis);
    }
    return sum / crossings.count;
}

/// The planes of the two sides of a thin ridge meet beyond it. A vertex there would fold the wall.
TEST_F(EachBrick, HasTheVertexOfALoopThatCrossesAFaceTwiceAtTheMeanOfItsCrossings) {
    int returning = 0;
    forEachBrick([&](const BrickNeighbourhood& nodes, const NodePoints& points, WallPolygons& found) {
        const WallVertices ofCells(nodes, found.cells());
        if (ofCells.areSimple()) return;
        const WallLoops loops(nodes, points, found.cells(), ofCells, found.polygons());
        for (const WallLoops::Vertex& vertex : loops.vertices()) {
            constexpr int kOnFace = 4;  // kinds of vertices from here on
            const CellLoops& around = kCellLoops[nodes.removedCorners(vertex.cell)];
            if (vertex.kind >= kOnFace || around.count > 1 || !around.hasAmbiguousFace) continue;
            const Vec3 place = placeIn(vertex.cell, vertex.point, points);
            EXPECT_LT((place - meanCrossing(nodes, vertex.cell)).norm(), kRounding);
            ++returning;
        }
    });
    EXPECT_GT(returning, 100);
}

}  // namespace
}  // namespace tactooth
