// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/camera/camera.h"

namespace tactooth {

/// The position and size of a small picture in a corner of the large one, in pixels from its upper left corner.
struct CornerRectangle {
    int left = 0, top = 0;
    ImageSize size;
};

}  // namespace tactooth
