// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// What is left after a cut along a path that leans and turns, against OpenVDB: level sets of the tooth's and the bur's
// triangles, the bur taken away at each of many poses (CSG of level sets, K. Museth, "VDB: High-Resolution Sparse
// Volumes with Dynamic Topology", ACM TOG 32, 2013). Shares no code with what it judges.
#include <gtest/gtest.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Composite.h>
#include <openvdb/tools/Interpolation.h>
#include <openvdb/tools/MeshToVolume.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "instruments/builtin_tooth.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"
#include "tooth/surface/incremental_surface.h"

namespace tactooth {
namespace {

using openvdb::FloatGrid;

constexpr double kVoxel = 0.025;    // mm, of the cut
constexpr double kFine = 0.02;      // mm, of the judge
constexpr double kRms = 0.005;      // mm, of the walls from where the judge has them
constexpr double kLargest = 0.012;  // mm

FloatGrid::Ptr levelSetOf(const TriangleMesh& mesh, const Pose& pose, const openvdb::math::Transform& transform) {
    std::vector<openvdb::Vec3s> points;
    for (const Vec3f& vertex : mesh.vertices) {
        const Vec3 point = pose.position + pose.rotation * vertex.cast<double>();
        points.emplace_back(static_cast<float>(point.x()), static_cast<float>(point.y()),
                            static_cast<float>(point.z()));
    }
    std::vector<openvdb::Vec3I> triangles;
    for (const Triangle& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
    return openvdb::tools::meshToLevelSet<FloatGrid>(transform, points, triangles);
}

/// Summed over the voxels, each as far as a plane through it at that distance leaves of it inside, mm^3. (The library's
/// own levelSetVolume integrates over the surface and is 5 % off where the intersection of two bodies has sharp edges.)
double volumeOf(const FloatGrid& body, const FloatGrid& around) {
    const auto values = body.getConstAccessor();
    double voxels = 0;
    for (const openvdb::Coord& place : around.evalActiveVoxelBoundingBox()) {
        voxels += std::clamp(0.5 - static_cast<double>(values.getValue(place)) / kFine, 0.0, 1.0);
    }
    return voxels * kFine * kFine * kFine;
}

/// A stroke of about a millimetre that begins above a place on the tooth, goes into it and leans while it goes; `step`
/// mm from pose to pose.
std::vector<Pose> stroke(const Vec3& place, double step, std::mt19937& random) {
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto lean = [&] {
        return Quat(Eigen::AngleAxisd(0.4 * unit(random), Vec3::UnitX()) *
                    Eigen::AngleAxisd(0.4 * unit(random), Vec3::UnitY()));
    };
    const std::array<Pose, 3> corners = {Pose{place + Vec3(0, 0, 0.2), lean()},
                                         Pose{place + Vec3(0.1 * unit(random), 0.1 * unit(random), -0.35), lean()},
                                         Pose{place + Vec3(0.5, 0.4 * unit(random), -0.3), lean()}};
    std::vector<Pose> path;
    for (std::size_t leg = 0; leg + 1 < corners.size(); ++leg) {
        const Pose& from = corners[leg];
        const Pose& to = corners[leg + 1];
        const int steps = static_cast<int>(std::ceil((to.position - from.position).norm() / step));
        for (int i = 0; i < steps; ++i) {
            const double t = static_cast<double>(i) / steps;
            path.push_back({from.position + t * (to.position - from.position), from.rotation.slerp(t, to.rotation)});
        }
    }
    return path;
}

struct Bur {
    TriangleMesh mesh;
    double step;  ///< mm; what stays between two of the judge's poses is to be small beside the bounds
};

void expectAsTheLevelSet(const TriangleMesh& outer, const Vec3& place, const Bur& bur, unsigned seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    const std::vector<Pose> path = stroke(place, bur.step, random);
    CutVolume volume(std::make_shared<const LayeredTooth>(std::move(*LayeredTooth::make(outer))), kVoxel);
    IncrementalSurface live(volume);
    const auto envelope = *RevolutionEnvelope::make(bur.mesh);
    double removed = 0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const CarveResult step = volume.carve(envelope, path[i], path[i + 1], 0);
        removed += total(step.removed);
        live.update(volume, step.changed);
    }

    const auto transform = openvdb::math::Transform::createLinearTransform(kFine);
    const FloatGrid::Ptr whole = levelSetOf(outer, {}, *transform);
    const FloatGrid::Ptr swept = levelSetOf(bur.mesh, path.front(), *transform);
    for (const Pose& pose : path) openvdb::tools::csgUnion(*swept, *levelSetOf(bur.mesh, pose, *transform));
    const double taken = volumeOf(*openvdb::tools::csgIntersectionCopy(*whole, *swept), *swept);
    EXPECT_NEAR(removed, taken, 0.003 * taken);
    EXPECT_GT(taken, 0.1);

    const FloatGrid::Ptr left = openvdb::tools::csgDifferenceCopy(*whole, *swept);
    const openvdb::tools::GridSampler<FloatGrid, openvdb::tools::BoxSampler> sample(*left);
    double squares = 0;
    double largest = 0;
    int count = 0;
    for (const auto& patch : live.snapshot()->patches) {
        for (const Vec3f& vertex : patch->mesh().vertices) {
            const double distance = sample.wsSample(openvdb::Vec3d(vertex.x(), vertex.y(), vertex.z()));
            squares += distance * distance;
            largest = std::max(largest, std::abs(distance));
            ++count;
        }
    }
    ASSERT_GT(count, 1000);
    EXPECT_LE(std::sqrt(squares / count), kRms);
    EXPECT_LE(largest, kLargest);
}

Bur ball() { return {test::sphere(Vec3(0, 0, 0.4), 0.4, 128, 96), 0.02}; }
/// A flat end that leans leaves a stair from pose to pose.
Bur fissure() { return {test::cylinder(Vec3::Zero(), 0.4, 0.8, 128), 0.01}; }

TEST(LevelSetOracle, FindsTheSameLeftOfABlock) {
    const TriangleMesh block = test::box(Vec3(-0.9, -1.1, -1), Vec3(1.4, 1.1, 0));
    expectAsTheLevelSet(block, Vec3::Zero(), fissure(), 2);
}

TEST(LevelSetOracle, FindsTheSameLeftOfATooth) {
    const TriangleMesh tooth = makeBuiltinTooth(BuiltinToothKind::UpperCentralIncisor, 20000).outer;
    const auto isLower = [](const Vec3f& a, const Vec3f& b) { return a.z() < b.z(); };
    const Vec3 top = std::ranges::max_element(tooth.vertices, isLower)->cast<double>();
    expectAsTheLevelSet(tooth, top, ball(), 3);
    expectAsTheLevelSet(tooth, top, fissure(), 3);
}

}  // namespace
}  // namespace tactooth
