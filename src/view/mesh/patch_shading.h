// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "view/mesh/corner_shading.h"

namespace tactooth {

/// A patch of a tooth and what is found out about it once: which of its triangles are pieces of triangles of the base,
/// left around a cut. The others are its wall. May be made on any thread.
struct ShadedPatch {
    /// `baseShading`: of the corners of `base`.
    ShadedPatch(std::shared_ptr<const SurfacePart> patch, const SurfacePart& base, const CornerShading& baseShading);

    using Position = std::array<float, 3>;
    static constexpr std::uint32_t kNotOfWall = UINT32_MAX;

    std::shared_ptr<const SurfacePart> part;
    std::vector<std::optional<std::uint32_t>> baseTriangles;  ///< one a triangle: of the base
    Box3 wall;                                                ///< of the wall's vertices
    std::vector<Position> positions;                          ///< of the wall's vertices, ascending, each once
    std::vector<std::uint32_t> positionOfVertex;              ///< one a vertex: in `positions`, or kNotOfWall
    std::vector<std::optional<AppearanceMix>>
        rimAppearances;  ///< one a place: the looks of the base, where it lies there
};

/// Shading of a patch. Where it carries on the surface of `base`, it takes over the shading of `base` (`baseShading`),
/// so that no seam shows, nor does one where its wall begins: there the wall has the looks of `base`. It is shaded as
/// one with the walls of `neighbours`, which share vertices with it. May be called on any thread.
[[nodiscard]] CornerShading patchShading(const ShadedPatch& patch, std::span<const ShadedPatch* const> neighbours,
                                         const SurfacePart& base, const CornerShading& baseShading);

}  // namespace tactooth
