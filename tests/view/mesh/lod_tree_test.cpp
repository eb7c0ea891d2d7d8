// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/mesh/lod_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "support/shapes.h"
#include "view/mesh/appearance_zones.h"

namespace tactooth {
namespace {

constexpr double kRadius = 4;  ///< mm, of the balls below

TriangleMesh ball() { return test::sphere(Vec3::Zero(), kRadius, 150, 100); }

ShadingMesh shaded(const TriangleMesh& mesh) { return shadingMesh(mesh, cornerShading(mesh)); }

/// Sees all of a body from +x, drawn with at most `error` mm of deviation at any distance.
ClusterCuller wholeView(double error) {
    Mat4 shrunk = Mat4::Identity();
    shrunk.topLeftCorner<3, 3>() *= 0.1 / kRadius;
    return {shrunk, Eigen::Vector4d(1, 0, 0, 0), false, error};
}

std::vector<Triangle> trianglesOf(const LodTree& tree, const std::vector<TriangleRange>& runs) {
    std::vector<Triangle> triangles;
    for (const TriangleRange& run : runs) {
        const auto part = std::span(tree.triangles).subspan(run.first, run.count);
        triangles.insert(triangles.end(), part.begin(), part.end());
    }
    return triangles;
}

std::vector<Triangle> drawn(const LodTree& tree, double error, const std::vector<bool>& mustRefine = {}) {
    std::vector<TriangleRange> runs;
    visibleRanges(wholeView(error), tree, mustRefine, runs);
    return trianglesOf(tree, runs);
}

Vec3f positionOf(const ShadingMesh& mesh, std::uint32_t vertex) { return Vec3f(mesh.vertices[vertex].position.data()); }

/// Edges, by the positions of their ends, that are not run through once in each direction.
std::size_t openEdges(const ShadingMesh& mesh, const std::vector<Triangle>& triangles) {
    using Place = std::array<float, 3>;
    std::map<std::pair<Place, Place>, int> edges;
    for (const Triangle& t : triangles) {
        for (std::size_t c = 0; c < 3; ++c) {
            const Place& from = mesh.vertices[t[c]].position;
            const Place& to = mesh.vertices[t[(c + 1) % 3]].position;
            from < to ? ++edges[{from, to}] : --edges[{to, from}];
        }
    }
    return static_cast<std::size_t>(
        std::count_if(edges.begin(), edges.end(), [](const auto& edge) { return edge.second != 0; }));
}

/// Greatest distance of a drawn corner or triangle centre from the true ball, mm.
double worstDeparture(const ShadingMesh& mesh, const std::vector<Triangle>& triangles) {
    double worst = 0;
    for (const Triangle& t : triangles) {
        const Vec3f middle = (positionOf(mesh, t[0]) + positionOf(mesh, t[1]) + positionOf(mesh, t[2])) / 3;
        worst = std::max(worst, std::abs(kRadius - static_cast<double>(middle.norm())));
    }
    return worst;
}

TEST(LodTree, DrawsTheTrueSurfaceWhereNoErrorIsAllowed) {
    const ShadingMesh mesh = shaded(ball());
    EXPECT_EQ(drawn(buildLodTree(mesh), 0), mesh.triangles);
}

TEST(LodTree, FewerTrianglesForMoreErrorAndAlwaysClosed) {
    const ShadingMesh mesh = shaded(ball());
    const LodTree tree = buildLodTree(mesh);
    std::size_t before = mesh.triangles.size() + 1;
    for (const double error : {0.0, 0.002, 0.005, 0.01, 0.02, 0.05, 0.2}) {
        const std::vector<Triangle> triangles = drawn(tree, error);
        EXPECT_LE(triangles.size(), before) << error;
        EXPECT_EQ(openEdges(mesh, triangles), 0U) << error;
        before = triangles.size();
    }
    EXPECT_LT(before, mesh.triangles.size() / 50);
}

TEST(LodTree, StaysWithinThreeTimesTheAllowedError) {
    const ShadingMesh mesh = shaded(ball());
    const LodTree tree = buildLodTree(mesh);
    const double own = worstDeparture(mesh, mesh.triangles);
    for (const double error : {0.005, 0.01, 0.02, 0.05, 0.1}) {
        const std::vector<Triangle> triangles = drawn(tree, error);
        EXPECT_LE(triangles.size(), mesh.triangles.size() / 2) << error;
        EXPECT_LE(worstDeparture(mesh, triangles), own + 3 * error) << error;
    }
}

TEST(LodTree, PiecesOfAnyResolutionFitTogether) {
    const ShadingMesh mesh = shaded(ball());
    const LodTree tree = buildLodTree(mesh);
    const std::size_t pieces = (mesh.triangles.size() + kTrianglesPerLeaf - 1) / kTrianglesPerLeaf;
    ASSERT_GT(pieces, 8U);
    for (std::size_t piece = 0; piece < pieces; ++piece) {
        std::vector<bool> mustRefine(tree.nodes.size());
        mustRefine[piece] = true;
        for (std::size_t i = pieces; i < tree.nodes.size(); ++i) {
            const LodNode& node = tree.nodes[i];
            for (std::size_t child = 0; child < node.children; ++child) {
                if (mustRefine[node.firstChild + child]) mustRefine[i] = true;
            }
        }
        const std::vector<Triangle> triangles = drawn(tree, 0.1, mustRefine);
        EXPECT_LT(triangles.size(), mesh.triangles.size() / 2);
        EXPECT_EQ(openEdges(mesh, triangles), 0U);
        const auto own = std::span(mesh.triangles).subspan(piece * kTrianglesPerLeaf).first(1);
        EXPECT_NE(std::find(triangles.begin(), triangles.end(), own.front()), triangles.end());
    }
}

TEST(LodTree, WhereTwoAppearancesMeetNoEdgeIsLeftOut) {
    const TriangleMesh mesh = ball();
    std::vector<SurfaceTag> tags(mesh.triangles.size());
    for (std::size_t t = 0; t < tags.size(); ++t) tags[t] = mesh.vertices[mesh.triangles[t][0]].z() > 0 ? 1 : 0;
    const ShadingMesh twoAppearances = shadingMesh(mesh, cornerShading(mesh, tags));
    const auto mixed = [&](const Triangle& t) {
        return twoAppearances.vertices[t[0]].appearances != twoAppearances.vertices[t[1]].appearances ||
               twoAppearances.vertices[t[1]].appearances != twoAppearances.vertices[t[2]].appearances;
    };
    std::vector<Triangle> coarse = drawn(buildLodTree(twoAppearances), 0.1);
    ASSERT_LT(coarse.size(), mesh.triangles.size() / 4);
    EXPECT_EQ(openEdges(twoAppearances, coarse), 0U);
    std::vector<Triangle> wanted = twoAppearances.triangles;
    std::erase_if(wanted, [&](const Triangle& t) { return !mixed(t); });
    std::erase_if(coarse, [&](const Triangle& t) { return !mixed(t); });
    std::sort(wanted.begin(), wanted.end());
    std::sort(coarse.begin(), coarse.end());
    EXPECT_GT(wanted.size(), 100U);
    EXPECT_EQ(coarse, wanted);
}

/// Thin enamel into thick, gingiva into mucosa: a number of appearances over the height, from one into the other within
/// 4 mm of 8.
class GradualBall : public AppearanceZones {
public:
    [[nodiscard]] AppearanceMix at(const Place& place) const override {
        return {0, 1, static_cast<std::uint8_t>(std::lround(255 * shareAt(place.point.z())))};
    }
    static double shareAt(double z) { return std::clamp(0.5 + z / 4, 0.0, 1.0); }
};

TEST(LodTree, AppearancesThatPassSlowlyIntoEachOtherAreSimplifiedWithinTheError) {
    const TriangleMesh mesh = ball();
    CornerShading shading = cornerShading(mesh);
    applyZones(GradualBall(), mesh, shading);
    const ShadingMesh zoned = shadingMesh(mesh, shading);
    const LodTree tree = buildLodTree(zoned);
    const double own = worstDeparture(zoned, zoned.triangles);
    for (const double error : {0.01, 0.02, 0.05}) {
        const std::vector<Triangle> triangles = drawn(tree, error);
        EXPECT_LE(triangles.size(), mesh.triangles.size() / 2) << error;
        EXPECT_EQ(openEdges(zoned, triangles), 0U) << error;
        EXPECT_LE(worstDeparture(zoned, triangles), own + 4 * error) << error;
        double worst = 0;  // difference of the drawn share from the true one, at the middles of the triangles
        for (const Triangle& t : triangles) {
            double drawnShare = 0, height = 0;
            for (const std::uint32_t vertex : t) {
                drawnShare += static_cast<double>(zoned.vertices[vertex].appearances >> 16 & 255U) / 255 / 3;
                height += static_cast<double>(zoned.vertices[vertex].position[2]) / 3;
            }
            worst = std::max(worst, std::abs(drawnShare - GradualBall::shareAt(height)));
        }
        EXPECT_LE(worst, 0.02 + 4 * error) << error;  // 0.25 mm stand for the whole way
    }
}

TEST(LodTree, ABodyOfFewTrianglesIsLeftAsItIs) {
    const ShadingMesh mesh = shaded(test::box(Vec3::Zero(), Vec3::Ones()));
    EXPECT_EQ(drawn(buildLodTree(mesh), 0.1), mesh.triangles);
}

TEST(LodTree, MoreErrorIsAllowedFarFromTheEyeThanNear) {
    const ClusterCuller culler(Mat4::Identity(), Eigen::Vector4d(0, 0, 0, 1), false, 0.01);
    EXPECT_FLOAT_EQ(culler.allowedError(Vec3f(100, 0, 0), 0), 1.0F);
    EXPECT_FLOAT_EQ(culler.allowedError(Vec3f(0, 100, 0), 40), 0.6F);
    EXPECT_FLOAT_EQ(culler.allowedError(Vec3f(0, 0, 5), 6), 0.0F);
}

}  // namespace
}  // namespace tactooth
