// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// S. Gottschalk, "Separating axis theorem", TR96-024, UNC Chapel Hill (1996): two convex bodies are disjoint if their
// projections on a normal of one of their faces, or on the cross product of an edge of each, are disjoint. Ours also
// handles triangles with a common corner: there the separating plane goes through that corner.
#include "geometry/mesh/triangle_intersection.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <utility>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

constexpr double kSeparation = kIntersectionDistance;

using Corners = std::array<Vec3, 3>;

/// Smallest and largest coordinate of points along a direction.
std::pair<double, double> projection(std::span<const Vec3> points, const Vec3& direction) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Vec3& point : points) {
        const double place = direction.dot(point);
        low = std::min(low, place);
        high = std::max(high, place);
    }
    return {low, high};
}

Vec3 unit(const Vec3& v) {
    const double length = v.norm();
    constexpr double kNone = 1e-12;
    return length > kNone ? Vec3(v / length) : Vec3(Vec3::Zero());
}

bool separatesThem(const Vec3& direction, const Corners& a, const Corners& b) {
    const auto [lowA, highA] = projection(a, direction);
    const auto [lowB, highB] = projection(b, direction);
    return lowB - highA > kSeparation || lowA - highB > kSeparation;
}

/// Two triangles without a common corner.
bool nonAdjacentIntersect(const Corners& a, const Corners& b) {
    const auto edges = [](const Corners& t) { return Corners{t[1] - t[0], t[2] - t[1], t[0] - t[2]}; };
    const Corners edgesA = edges(a), edgesB = edges(b);
    const Vec3 normalA = unit(edgesA[0].cross(edgesA[1])), normalB = unit(edgesB[0].cross(edgesB[1]));
    if (separatesThem(normalA, a, b) || separatesThem(normalB, a, b)) return false;
    for (const Vec3& edge : edgesA) {
        if (separatesThem(unit(edge.cross(normalA)), a, b)) return false;
        for (const Vec3& other : edgesB) {
            if (separatesThem(unit(edge.cross(other)), a, b)) return false;
        }
    }
    return std::ranges::none_of(edgesB,
                                [&](const Vec3& edge) { return separatesThem(unit(edge.cross(normalB)), a, b); });
}

using Sides = std::array<Vec3, 2>;

/// Whether the plane through the common corner, perpendicular to `direction`, has one triangle on each side. A side of
/// each may be in the plane.
bool separatesCones(const Vec3& direction, const Sides& a, const Sides& b) {
    const auto [lowA, highA] = projection(a, direction);
    const auto [lowB, highB] = projection(b, direction);
    constexpr double kInPlane = 1e-9;
    return (highA < kInPlane && lowB > -kInPlane && lowA < -kSeparation && highB > kSeparation) ||
           (highB < kInPlane && lowA > -kInPlane && lowB < -kSeparation && highA > kSeparation);
}

/// Two triangles with one common corner; unit vectors from there along their sides.
bool conesIntersect(const Sides& a, const Sides& b) {
    const Vec3 normalA = unit(a[0].cross(a[1])), normalB = unit(b[0].cross(b[1]));
    // First the planes of the triangles: the other triangle may touch a plane in the corner only. On a smooth surface
    // this decides most cases.
    const auto isBeside = [](const Vec3& normal, const Sides& other) {
        const double one = normal.dot(other[0]), two = normal.dot(other[1]);
        return std::min(one, two) > kSeparation || std::max(one, two) < -kSeparation;
    };
    if (isBeside(normalA, b) || isBeside(normalB, a)) return false;
    constexpr double kSame = 1 - 1e-12;  // cosine
    for (const Vec3& side : a) {
        for (const Vec3& other : b) {
            if (side.dot(other) > kSame) return true;
        }
    }
    const auto parts = [&](const Vec3& direction) { return separatesCones(direction, a, b); };
    for (const Vec3& side : a) {
        if (parts(unit(side.cross(normalA)))) return false;
        for (const Vec3& other : b) {
            if (parts(unit(side.cross(other)))) return false;
        }
    }
    return std::ranges::none_of(b, [&](const Vec3& side) { return parts(unit(side.cross(normalB))); });
}

/// Two triangles with a common edge, folded onto each other; vectors from one end of the edge.
bool leavesOverlap(const Vec3& edge, const Vec3& a, const Vec3& b) {
    const Vec3 along = unit(edge);
    const Vec3 outA = unit(a - along.dot(a) * along), outB = unit(b - along.dot(b) * along);
    constexpr double kFolded = 1 - 1e-10;  // cosine: an angle of 1e-5
    return outA.dot(outB) > kFolded;
}

}  // namespace

bool trianglesIntersect(const TriangleMesh& mesh, std::uint32_t a, std::uint32_t b) {
    TACTOOTH_ASSERT(a != b);
    TACTOOTH_ASSERT(a < mesh.triangles.size() && b < mesh.triangles.size());
    const Triangle &first = mesh.triangles[a], &second = mesh.triangles[b];
    Corners cornersA = {mesh.corner(a, 0), mesh.corner(a, 1), mesh.corner(a, 2)};
    Corners cornersB = {mesh.corner(b, 0), mesh.corner(b, 1), mesh.corner(b, 2)};
    // Move common corners to the front of both.
    int common = 0;
    std::array<std::uint32_t, 3> namesB = second;
    for (int i = 0; i < 3; ++i) {
        const auto found = std::find(namesB.begin() + common, namesB.end(), first[i]);
        if (found == namesB.end()) continue;
        const auto place = found - namesB.begin();
        std::swap(cornersA[i], cornersA[common]);
        std::swap(namesB[place], namesB[common]);
        std::swap(cornersB[place], cornersB[common]);
        ++common;
    }
    if (common == 0) return nonAdjacentIntersect(cornersA, cornersB);
    const Vec3& from = cornersA[0];
    if (common == 1) {
        return conesIntersect({unit(cornersA[1] - from), unit(cornersA[2] - from)},
                              {unit(cornersB[1] - from), unit(cornersB[2] - from)});
    }
    return common == 3 || leavesOverlap(cornersA[1] - from, cornersA[2] - from, cornersB[2] - from);
}

}  // namespace tactooth
