// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "view/mesh/appearance_zones.h"

namespace tactooth {

/// A patch of a tooth with data that is computed once: which of its triangles are pieces of base triangles, left around
/// a cut. The other triangles are its wall. May be made on any thread.
struct ShadedPatch {
    /// `baseShading`: of the corners of `base`.
    ShadedPatch(std::shared_ptr<const SurfacePart> patch, const SurfacePart& base, const CornerShading& baseShading);

    using Position = std::array<float, 3>;
    static constexpr std::uint32_t kNotOfWall = UINT32_MAX;

    std::shared_ptr<const SurfacePart> part;
    std::vector<std::optional<std::uint32_t>> baseTriangles;  ///< one per triangle: its base triangle
    Box3 wall;                                                ///< of the wall's vertices
    std::vector<Position> positions;                          ///< of the wall's vertices, ascending, without duplicates
    std::vector<std::uint32_t> positionOfVertex;              ///< one per vertex: index in `positions`, or kNotOfWall
    std::vector<std::optional<AppearanceMix>> rimAppearances;  ///< the appearances of the base, for positions on it
};

/// Shading of a patch. Where it continues the surface of `base`, it has the shading of `base` (`baseShading`), so that
/// no seam is visible. Where its wall begins, the wall has the appearances of `base`, so that no seam is visible there
/// either. Elsewhere `zones`, if there are any, say how the materials of the wall look. The wall is shaded together
/// with the walls of `neighbours`, which share vertices with it. May be called on any thread.
[[nodiscard]] CornerShading patchShading(const ShadedPatch& patch, std::span<const ShadedPatch* const> neighbours,
                                         const SurfacePart& base, const CornerShading& baseShading,
                                         const AppearanceZones* zones = nullptr);

}  // namespace tactooth
