// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/surface/intersection_filter.h"

#include <algorithm>
#include <limits>

#include "geometry/util/assert.h"

// Source: the filter of exact_sign.cpp (J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust
// Geometric Predicates", 1997). Difference: single precision. Corners of a tooth's triangles lie so close together that
// their differences lose almost nothing, so that the filter separates nearly all pairs that do not cross.

namespace tactooth {
namespace {

Float8 size(const Float8& a) { return max(a, Float8::all(0) - a); }
Vec3x8 sizes(const Vec3x8& a) { return {size(a.x), size(a.y), size(a.z)}; }

}  // namespace

IntersectionFilter::Planes IntersectionFilter::Planes::through(const Vec3x8& a, const Vec3x8& b, const Vec3x8& c) {
    const Vec3x8 u = b - a;
    const Vec3x8 v = c - a;
    const Vec3x8 permanent = {size(u.y * v.z) + size(u.z * v.y), size(u.z * v.x) + size(u.x * v.z),
                              size(u.x * v.y) + size(u.y * v.x)};
    return {a, cross(u, v), permanent};
}

std::uint32_t IntersectionFilter::Planes::leaveOnOneSide(const std::array<Vec3x8, 3>& points) const {
    const Float8 filter = Float8::all(16 * std::numeric_limits<float>::epsilon());
    const Float8 underflow = Float8::all(1e-30F);  // exceeds what products lose that are too small for a float
    std::uint32_t inFront = 0xFF;
    std::uint32_t behind = 0xFF;
    for (const Vec3x8& point : points) {
        const Vec3x8 away = point - origin;
        const Float8 determinant = dot(normal, away);
        const Float8 bound = filter * dot(permanent, sizes(away)) + underflow;
        inFront &= lessEqual(bound, determinant);
        behind &= lessEqual(determinant, Float8::all(0) - bound);
    }
    return inFront | behind;
}

IntersectionFilter::Face::Face(const std::array<Vec3f, 3>& corners) {
    for (int i = 0; i < 3; ++i) corner[i] = Vec3x8::all(corners[i].x(), corners[i].y(), corners[i].z());
    plane = Planes::through(corner[0], corner[1], corner[2]);
}

IntersectionFilter::IntersectionFilter(const TriangleMesh& mesh, std::span<const std::uint32_t> triangles)
    : eights_((triangles.size() + 7) / 8) {
    constexpr float kAbsent = std::numeric_limits<float>::quiet_NaN();
    for (std::size_t first = 0; first < triangles.size(); first += 8) {
        Eight& eight = eights_[first / 8];
        const std::size_t count = std::min<std::size_t>(8, triangles.size() - first);
        float corner[3][3][8];
        std::fill_n(&corner[0][0][0], 3 * 3 * 8, kAbsent);
        for (std::size_t lane = 0; lane < count; ++lane) {
            eight.triangle[lane] = triangles[first + lane];
            TACTOOTH_ASSERT(eight.triangle[lane] < mesh.triangles.size());
            const Triangle& v = mesh.triangles[eight.triangle[lane]];
            for (int c = 0; c < 3; ++c) {
                for (int axis = 0; axis < 3; ++axis) corner[c][axis][lane] = mesh.vertices[v[c]][axis];
            }
        }
        for (int c = 0; c < 3; ++c) eight.corner[c] = Vec3x8::load(corner[c]);
        eight.low = min(min(eight.corner[0], eight.corner[1]), eight.corner[2]);
        eight.high = max(max(eight.corner[0], eight.corner[1]), eight.corner[2]);
        eight.planes = Planes::through(eight.corner[0], eight.corner[1], eight.corner[2]);
    }
}

}  // namespace tactooth
