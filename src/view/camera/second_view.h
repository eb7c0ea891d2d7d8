// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/camera/camera.h"

namespace tactooth {

/// A small picture of the same scene from another side, without mirror and handles, in the upper right corner of the
/// picture. There is none in stereo.
struct SecondView {
    Camera camera;
};

inline constexpr double kSecondViewAspect = 4.0 / 3.0;  ///< a tooth with its bur is about as high as wide

/// The position and size of the second view, in pixels from the picture's upper left corner.
struct SecondViewRectangle {
    int left = 0, top = 0;
    ImageSize size;
};
[[nodiscard]] SecondViewRectangle secondViewRectangle(ImageSize picture);

inline constexpr double kMagnification = 4;

/// The magnifier's square in the upper left corner of the picture.
[[nodiscard]] SecondViewRectangle magnifierRectangle(ImageSize picture);

/// The camera of the magnifier: `place` (world) in its middle, kMagnification times as large as in a picture of this
/// size by `camera`.
[[nodiscard]] Camera magnifierCamera(const Camera& camera, ImageSize picture, const Vec3& place);

}  // namespace tactooth
