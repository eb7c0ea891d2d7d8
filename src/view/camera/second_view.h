// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/camera/camera.h"

namespace tactooth {

/// A small picture of the same scene from another side, without mirror and handles, in the upper right corner of the
/// picture. There is none in stereo.
struct SecondView {
    Camera camera;
    bool redraw = true;  ///< else the last picture may stay while its size does: this view may lag behind the hand
};

inline constexpr double kSecondViewAspect = 4.0 / 3.0;  ///< a tooth with its bur is about as high as wide

/// The position and size of the second view, in pixels from the picture's upper left corner.
struct SecondViewRectangle {
    int left = 0, top = 0;
    ImageSize size;
};
[[nodiscard]] SecondViewRectangle secondViewRectangle(ImageSize picture);

}  // namespace tactooth
