// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/camera/corner_rectangle.h"

namespace tactooth {

/// A small picture of the same scene from another side, without mirror and handles, in the upper right corner of the
/// picture. There is none in stereo.
struct SecondView {
    Camera camera;
};

inline constexpr double kSecondViewAspect = 4.0 / 3.0;  ///< a tooth with its bur is about as high as wide

/// Where the second view is in a picture of this size.
[[nodiscard]] CornerRectangle secondViewRectangle(ImageSize picture);

}  // namespace tactooth
