// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "collision/surface.h"
#include "collision/tool_shape.h"
#include "geometry/pose.h"

namespace tactooth {

/// Of a length computed in single precision by a few operations: what rounding has made of it at most.
inline constexpr double kFewRoundings = 1e-6;

[[nodiscard]] inline Vec3x8 everywhere(const Vec3f& v) { return Vec3x8::all(v.x(), v.y(), v.z()); }

/// Where a tool may move before it meets what was not near: its origin (the tip) is shifted to within `around` of the
/// segment from where it was to `along` further on, and it is turned by `turn`. A turn moves its point p by
/// turn * |p| at most.
struct Skin {
    Vec3 along = Vec3::Zero();  ///< mm, in the tooth's frame
    double around = 0;          ///< mm
    double turn = 0;            ///< chord: twice the sine of half the angle

    /// Distance of a shift from the segment, mm.
    [[nodiscard]] double stray(const Vec3& shift) const {
        const double squared = along.squaredNorm();
        const double share = squared > 0 ? std::clamp(shift.dot(along) / squared, 0.0, 1.0) : 0;
        return (shift - share * along).norm();
    }
};

/// Up to eight triangles of a tooth, a leaf of its tree, in the tool's frame.
struct alignas(32) NearLeaf {
    float corner[3][3][AabbTree::kWidth];  ///< corner by corner, axis by axis, mm
    float normal[3][AabbTree::kWidth];     ///< unit; shorter where a triangle has no area
    std::uint32_t triangle[AabbTree::kWidth];
    std::uint32_t part;
    std::uint32_t present;  ///< one bit for each triangle that is there
};

/// Eight clusters side by side. A cluster is a leaf of the tooth against one triangle of the tool, and a slab between
/// them: along `normal` (of the tool's frame, of length 1 at most, from tooth to tool) they are `gap` mm apart, or
/// overlap by that where it is negative.
struct alignas(32) EightClusters {
    float normal[3][8];
    float gap[8];
    float centre[3][8];  ///< ball around the tool's triangle, mm
    float radius[8];
    std::uint32_t leaf[8];  ///< place in `leaves`
    std::uint32_t tool[8];  ///< triangle of the tool
};

/// All that is near a tool. Fixed memory: filling it allocates nothing.
struct NearClusters {
    explicit NearClusters(std::size_t capacity) : leaves(capacity / 4), eights(capacity / 8) {}

    [[nodiscard]] std::size_t capacity() const { return eights.size() * 8; }

    std::vector<NearLeaf> leaves;
    std::vector<EightClusters> eights;
    std::size_t leafCount = 0;
    std::size_t count = 0;      ///< clusters
    double slack = 0;           ///< mm: what single precision may hide in a coordinate here
    std::size_t leavesMet = 0;  ///< leaves of the tooth that the search had to look into
    bool complete = true;       ///< false: there were more than `limit` clusters, or more than there is room for
};

/// Finds every cluster of `surface` and `tool` (standing at `toolInTooth`) whose triangles the tool could bring
/// together while it moves within `skin`, and some that it could not. Gives up beyond `limit` clusters.
void findNearClusters(const Surface& surface, const ToolShape& tool, const Pose& toolInTooth, const Skin& skin,
                      std::size_t limit, NearClusters& out);

}  // namespace tactooth
