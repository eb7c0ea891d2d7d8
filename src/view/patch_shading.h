// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "view/corner_shading.h"

namespace tactooth {

/// A patch of a tooth and what is found out about it once: which of its triangles are pieces of triangles of the base,
/// left around a cut. The others are its wall.
struct ShadedPatch {
    ShadedPatch(std::shared_ptr<const SurfacePart> patch, const SurfacePart& base);

    std::shared_ptr<const SurfacePart> part;
    std::vector<std::optional<std::uint32_t>> carriedOn;  ///< one a triangle: of the base
    Box3 wall;                                            ///< of the wall's vertices
};

/// Shading of a patch. Where it carries on the surface of `base`, it takes over the shading of `base` (`baseShading`),
/// so that no seam shows, nor does one where its wall begins: there the wall has the looks of `base`. It is shaded as
/// one with the walls of `neighbours`, which share vertices with it.
[[nodiscard]] CornerShading patchShading(const ShadedPatch& patch, std::span<const ShadedPatch* const> neighbours,
                                         const SurfacePart& base, const CornerShading& baseShading);

}  // namespace tactooth
