// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/preparation/cut_patch.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <map>

#include "geometry/util/disjoint_sets.h"
#include "geometry/util/parallel_for.h"

namespace tactooth {
namespace {

using Edge = std::array<std::uint32_t, 2>;

/// The edges that belong to one triangle of the patch alone.
std::vector<Edge> borderOf(const TriangleMesh& mesh, const CutPatch& patch) {
    std::vector<Edge> edges;
    for (const std::uint32_t i : patch) {
        const Triangle& t = mesh.triangles[i];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b)});
        }
    }
    std::sort(edges.begin(), edges.end());
    std::vector<Edge> border;
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t end = i;
        while (end < edges.size() && edges[end] == edges[i]) ++end;
        if (end - i == 1) border.push_back(edges[i]);
        i = end;
    }
    return border;
}

double squaredToEdge(const Vec3& point, const Vec3& a, const Vec3& b) {
    const Vec3 along = b - a;
    const double length = along.squaredNorm();
    const double share = length > 0 ? std::clamp((point - a).dot(along) / length, 0.0, 1.0) : 0;
    return (point - a - share * along).squaredNorm();
}

}  // namespace

std::vector<CutPatch> connectedPieces(const CutSurfaces& surfaces, const CutPatch& patch) {
    const TriangleMesh& mesh = surfaces.cut.mesh;
    DisjointSets sets(mesh.vertices.size());
    for (const std::uint32_t i : patch) {
        sets.join(mesh.triangles[i][0], mesh.triangles[i][1]);
        sets.join(mesh.triangles[i][0], mesh.triangles[i][2]);
    }
    std::map<std::uint32_t, CutPatch> pieces;
    for (const std::uint32_t i : patch) pieces[sets.find(mesh.triangles[i][0])].push_back(i);
    std::vector<std::pair<double, CutPatch>> measured;
    for (auto& [first, piece] : pieces) measured.emplace_back(areaOf(surfaces, piece), std::move(piece));
    std::stable_sort(measured.begin(), measured.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<CutPatch> sorted;
    for (auto& [area, piece] : measured) sorted.push_back(std::move(piece));
    return sorted;
}

CutPatch withoutBorder(const CutSurfaces& surfaces, const CutPatch& patch, double width) {
    const TriangleMesh& mesh = surfaces.cut.mesh;
    const std::vector<Edge> border = borderOf(mesh, patch);
    std::vector<std::uint8_t> isInner(patch.size());
    constexpr std::size_t kGrain = 16;  // triangles with some thousand edges each
    parallelFor(
        patch.size(),
        [&](std::size_t i) {
            const Vec3& centre = surfaces.facets[patch[i]].centre;
            isInner[i] = std::ranges::all_of(border, [&](const Edge& edge) {
                const Vec3 a = mesh.vertices[edge[0]].cast<double>(), b = mesh.vertices[edge[1]].cast<double>();
                return squaredToEdge(centre, a, b) >= width * width;
            });
        },
        kGrain);
    CutPatch inner;
    for (std::size_t i = 0; i < patch.size(); ++i) {
        if (isInner[i] != 0) inner.push_back(patch[i]);
    }
    return inner;
}

double areaOf(const CutSurfaces& surfaces, const CutPatch& patch) {
    double area = 0;
    for (const std::uint32_t i : patch) area += surfaces.facets[i].area;
    return area;
}

CutPatch patchBetween(const CutSurfaces& surfaces, const Vec3& axis, double low, double high) {
    CutPatch patch;
    for (std::uint32_t i = 0; i < surfaces.facets.size(); ++i) {
        const double cosine = surfaces.facets[i].normal.dot(axis);
        if (cosine > low && cosine < high) patch.push_back(i);
    }
    return patch;
}

LeastSpread leastSpread(const CutSurfaces& surfaces, const CutPatch& patch, Vec3 Facet::*part) {
    TACTOOTH_ASSERT(!patch.empty());
    const double area = std::max(areaOf(surfaces, patch), 1e-12);
    Vec3 mean = Vec3::Zero();
    for (const std::uint32_t i : patch) mean += surfaces.facets[i].area / area * surfaces.facets[i].*part;
    Mat3 spread = Mat3::Zero();
    for (const std::uint32_t i : patch) {
        const Vec3 from = surfaces.facets[i].*part - mean;
        spread += surfaces.facets[i].area / area * from * from.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Mat3> axes(spread);
    return {mean, axes.eigenvectors().col(0), std::sqrt(std::max(0.0, axes.eigenvalues()[0]))};
}

}  // namespace tactooth
