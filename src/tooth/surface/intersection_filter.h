// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "collision/narrow/simd8.h"
#include "geometry/mesh/triangle_mesh.h"
#include "geometry/util/assert.h"

namespace tactooth {

/// A quick test which triangles of a mesh may cross another triangle. It tests eight triangles at a time: first their
/// bounding boxes, then whether one triangle clearly lies on one side of the other's plane.
class IntersectionFilter {
public:
    IntersectionFilter(const TriangleMesh& mesh, std::span<const std::uint32_t> triangles);

    [[nodiscard]] bool empty() const { return eights_.empty(); }

    /// Calls `visit(triangle)` for each triangle that may cross a triangle with these corners, in their order. This
    /// includes all that do (`intersectionOf`), and few others.
    template <class Visit>
    void forCandidates(const std::array<Vec3f, 3>& corners, const Visit& visit) const {
        TACTOOTH_ASSERT(corners[0].allFinite() && corners[1].allFinite() && corners[2].allFinite());
        const Vec3f low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]);
        const Vec3f high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
        std::optional<Face> face;  // most queries do not need it
        for (const Eight& eight : eights_) {
            std::uint32_t touching = eight.touching(low, high);
            if (touching == 0) continue;
            if (!face) face.emplace(corners);
            touching &= ~eight.missed(*face);
            for (; touching != 0; touching &= touching - 1) visit(eight.triangle[std::countr_zero(touching)]);
        }
    }

private:
    /// Eight planes through three points each, or one plane eight times.
    struct Planes {
        Vec3x8 origin;
        Vec3x8 normal;
        Vec3x8 permanent;  ///< the same sum as `normal`, with absolute values

        static Planes through(const Vec3x8& a, const Vec3x8& b, const Vec3x8& c);
        /// The lanes in which all three points are clearly on one side.
        [[nodiscard]] std::uint32_t leaveOnOneSide(const std::array<Vec3x8, 3>& points) const;
    };
    /// The queried triangle, eight times.
    struct Face {
        explicit Face(const std::array<Vec3f, 3>& corners);
        std::array<Vec3x8, 3> corner;
        Planes plane;
    };
    struct Eight {
        std::array<Vec3x8, 3> corner;
        Vec3x8 low, high;  ///< NaN in unused lanes, so that they touch nothing
        Planes planes;
        std::array<std::uint32_t, 8> triangle;

        [[nodiscard]] std::uint32_t touching(const Vec3f& boxLow, const Vec3f& boxHigh) const {
            const auto onAxis = [](const Float8& ownLow, const Float8& ownHigh, float otherLow, float otherHigh) {
                return lessEqual(ownLow, Float8::all(otherHigh)) & lessEqual(Float8::all(otherLow), ownHigh);
            };
            return onAxis(low.x, high.x, boxLow.x(), boxHigh.x()) & onAxis(low.y, high.y, boxLow.y(), boxHigh.y()) &
                   onAxis(low.z, high.z, boxLow.z(), boxHigh.z());
        }
        [[nodiscard]] std::uint32_t missed(const Face& face) const {
            return face.plane.leaveOnOneSide(corner) | planes.leaveOnOneSide(face.corner);
        }
    };
    std::vector<Eight> eights_;
};

}  // namespace tactooth
