// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "collision/bvh/surface.h"
#include "tooth/model/layered_tooth.h"

namespace tactooth {

/// Depth below the uncut surface from which on a target counts as cavity, mm: less than the 25 um of a usual voxel,
/// more than storing or simplifying moves the surface of a scan.
inline constexpr double kCavityDepth = 0.02;

/// Longest edge of the walls, mm, so that the part that is not reached yet can be shown.
inline constexpr double kCavityEdge = 0.15;

/// The walls and floors of cavities, with normals into the cavities.
struct CavityWalls {
    TriangleMesh mesh;
    /// Where the walls end, kCavityDepth below the uncut surface: directed edges of `mesh`, the walls on their left as
    /// seen from the cavity.
    std::vector<std::array<std::uint32_t, 2>> rim;
};

/// Of the ideal shape `target` of a tooth what lies inside `outer`, the closed surface of the uncut tooth, by more than
/// kCavityDepth: its triangles there, divided until no edge is longer than kCavityEdge and cut off along that depth.
/// The same on any number of threads.
[[nodiscard]] CavityWalls cavityWalls(const TriangleMesh& target, const SurfacePart& outer);

/// Least distance of the walls from the pulp of `tooth`, mm; negative where the cavity opens it. Nothing without pulp
/// or walls.
[[nodiscard]] std::optional<double> leastToPulp(const CavityWalls& walls, const LayeredTooth& tooth);

}  // namespace tactooth
