// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "collision/surface.h"
#include "collision/tool_shape.h"
#include "geometry/pose.h"

namespace tactooth {

/// A triangle of the tooth and one of the tool that are near each other.
struct NearPair {
    std::uint32_t part;     ///< 0 = the surface's base, i + 1 = its patch i
    std::uint32_t tooth;    ///< triangle of that part
    std::uint32_t tool;     ///< triangle of the tool
    float distanceAtLeast;  ///< mm: the two are no nearer than this (not their distance, only a bound)
    /// Of length 1 at most, from tooth to tool, in the tool's frame: a slab across it, `distanceAtLeast` wide, is free
    /// of both triangles. Says nothing where `distanceAtLeast` is 0.
    std::array<float, 3> normal;
};

/// The part of `surface` that a pair's number names.
[[nodiscard]] inline const SurfacePart& partOf(const Surface& surface, std::uint32_t part) {
    return part == 0 ? *surface.base : *surface.patches[part - 1];
}

struct NearPairsFound {
    std::size_t count = 0;
    bool complete = true;  ///< false: there were more pairs than `out` holds
};

/// Every pair of triangles of `surface` and `tool` (standing at `toolInTooth`) nearer than `reach` mm, and some that
/// are not, written to `out`. Allocates nothing.
[[nodiscard]] NearPairsFound findNearPairs(const Surface& surface, const ToolShape& tool, const Pose& toolInTooth,
                                           double reach, std::span<NearPair> out);

}  // namespace tactooth
