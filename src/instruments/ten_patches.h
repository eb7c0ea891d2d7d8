// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "collision/proxy/qp3.h"
#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// A test piece: a block of 10 x 10 mm whose top (+z) is a valley of ten flat patches. The space above it is the
/// intersection of ten half-spaces, so that the exact displacement of a tool is known.
struct TenPatches {
    static constexpr std::size_t kPatches = 10;

    TriangleMesh surface;                        ///< closed, mm
    std::array<HalfSpace, kPatches> freeSpace;   ///< the space above the patches
    std::array<std::uint32_t, kPatches> first;   ///< first triangle of each patch
    std::array<std::uint32_t, kPatches> behind;  ///< one past its last triangle

    // Points on the surface to press a tool against.
    Vec3 a;  ///< within a patch: one patch holds the tool
    Vec3 b;  ///< on the valley line: two
    Vec3 c;  ///< in the lowest corner: three
};

[[nodiscard]] TenPatches makeTenPatches();

/// Position of the tip of `tool` as close as possible to that of the device pose without entering the block, with the
/// orientation of the device. It is the exact answer from the ten half-spaces, as long as no part of the tool is beyond
/// the block's top. `tool` has its tip at its origin.
[[nodiscard]] Vec3 nearestFreeTip(const TenPatches& piece, const TriangleMesh& tool, const Pose& device);

}  // namespace tactooth
