// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/camera/corner_rectangle.h"

namespace tactooth {

inline constexpr double kMagnification = 4;

/// The magnifier's square in the upper left corner of the picture.
[[nodiscard]] CornerRectangle magnifierRectangle(ImageSize picture);

/// The camera of the magnifier: `place` (world) in its middle, kMagnification times as large as in a picture of this
/// size by `camera`.
[[nodiscard]] Camera magnifierCamera(const Camera& camera, ImageSize picture, const Vec3& place);

}  // namespace tactooth
