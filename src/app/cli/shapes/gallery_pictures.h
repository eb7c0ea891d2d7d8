// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "geometry/util/expected.h"
#include "instruments/builtin_tooth.h"
#include "instruments/bur_catalogue.h"
#include "view/camera/orbit_camera.h"
#include "view/render/offscreen.h"

namespace tactooth {

/// Draws a tooth from one of the standard sides. All teeth have one scale: `millimetres` along the height of the
/// picture. Upper teeth stand as in the mouth, roots up.
[[nodiscard]] Expected<Image> toothPicture(OffscreenRenderer& renderer, const std::shared_ptr<const Surface>& surface,
                                           int fdi, StandardView view, double millimetres, ImageSize size);

/// The tooth's surface; the tag of each triangle is its material.
[[nodiscard]] Expected<std::shared_ptr<const Surface>> shownSurface(const BuiltinTooth& tooth);

/// Draws a bur that stands on its tip.
[[nodiscard]] Expected<Image> burPicture(OffscreenRenderer& renderer, const BurSpec& spec, double millimetres,
                                         ImageSize size);

/// Draws any other steel instrument, as large as the picture allows.
[[nodiscard]] Expected<Image> instrumentPicture(OffscreenRenderer& renderer, const TriangleMesh& mesh, ImageSize size);

}  // namespace tactooth
