// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/preparation/preparation.h"

#include <algorithm>
#include <cmath>

#include "collision/bvh/closest_point.h"
#include "geometry/util/disjoint_sets.h"

namespace tactooth {
namespace {

constexpr double kAlongAxis = 0.7;   // cosine from which on a direction runs along the axis rather than across it
constexpr double kSpeckArea = 0.05;  // mm^2: the noise of a scanner makes smaller pieces of cut surface
constexpr double kSpeckDepth = 0.1;  // mm: several times that noise

Vec3 acrossOr(const Vec3& direction, const Vec3& axis, const Vec3& other) {
    const Vec3 across = direction - direction.dot(axis) * axis;
    return across.norm() > 0.1 ? across.normalized() : other;
}

/// Leaves out the pieces that are both small and shallow: the roughness of a scan.
void removeSpecks(CavityWalls& walls, const SurfacePart& original) {
    DisjointSets pieces(walls.mesh.vertices.size());
    for (const Triangle& t : walls.mesh.triangles) {
        pieces.join(t[0], t[1]);
        pieces.join(t[0], t[2]);
    }
    std::vector<double> area(walls.mesh.vertices.size());
    for (std::size_t i = 0; i < walls.mesh.triangles.size(); ++i) {
        area[pieces.find(walls.mesh.triangles[i][0])] += walls.mesh.areaVector(i).norm() / 2;
    }
    std::vector<double> depth(walls.mesh.vertices.size());
    for (std::uint32_t i = 0; i < walls.mesh.vertices.size(); ++i) {
        const std::uint32_t piece = pieces.find(i);
        if (area[piece] >= kSpeckArea || area[piece] == 0) continue;
        const double here = closestPoint(original, walls.mesh.vertices[i].cast<double>())->distance;
        depth[piece] = std::max(depth[piece], here);
    }
    const auto isSpeck = [&](std::uint32_t vertex) {
        const std::uint32_t piece = pieces.find(vertex);
        return area[piece] < kSpeckArea && depth[piece] < kSpeckDepth;
    };
    std::erase_if(walls.mesh.triangles, [&](const Triangle& t) { return isSpeck(t[0]); });
    std::erase_if(walls.rim, [&](const auto& edge) { return isSpeck(edge[0]); });
}

Vec3 middleOf(const std::vector<Facet>& facets) {
    Vec3 sum = Vec3::Zero();
    double area = 0;
    for (const Facet& facet : facets) {
        sum += facet.area * facet.centre;
        area += facet.area;
    }
    return area > 0 ? Vec3(sum / area) : sum;
}

}  // namespace

std::vector<Facet> facetsOf(const TriangleMesh& mesh) {
    std::vector<Facet> facets;
    facets.reserve(mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Vec3 area = mesh.areaVector(i);
        facets.push_back({(mesh.corner(i, 0) + mesh.corner(i, 1) + mesh.corner(i, 2)) / 3, area.stableNormalized(),
                          area.norm() / 2});
    }
    return facets;
}

DentalDirections::DentalDirections(const Vec3& newAxis, double mesialX) : axis(newAxis) {
    const Vec3 toMesial = mesialX * Vec3::UnitX();
    hasMesial = std::abs(axis.dot(toMesial)) < kAlongAxis;
    hasBuccal = std::abs(axis.y()) < kAlongAxis;
    mesial = acrossOr(toMesial, axis, axis.unitOrthogonal());
    buccal = axis.cross(mesial);
    if (buccal.y() < 0) buccal = -buccal;
}

CutSurfaces::CutSurfaces(const Preparation& preparation)
    : cut(cavityWalls(preparation.prepared->mesh(), *preparation.original)),
      idealCut(cavityWalls(preparation.ideal->mesh(), *preparation.original)) {
    removeSpecks(cut, *preparation.original);
    removeSpecks(idealCut, *preparation.original);
    facets = facetsOf(cut.mesh);
    middle = middleOf(facets.empty() ? facetsOf(idealCut.mesh) : facets);
    double outward = 0;
    for (const Facet& facet : facets) {
        const Vec3 level = facet.normal - facet.normal.dot(preparation.axis) * preparation.axis;
        outward += facet.area * level.dot(facet.centre - middle);
    }
    isCrown = outward > 0;
}

}  // namespace tactooth
