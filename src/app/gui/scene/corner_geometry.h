// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRect>
#include <cmath>

#include "view/camera/corner_rectangle.h"

namespace tactooth {

/// The place of a small picture on the widget that shows the large one. `pixelRatio`: pixels of the picture for each
/// one of the widget.
[[nodiscard]] inline QRect cornerGeometry(const CornerRectangle& corner, double pixelRatio) {
    const auto scaled = [pixelRatio](int pixels) { return static_cast<int>(std::lround(pixels / pixelRatio)); };
    return {scaled(corner.left), scaled(corner.top), scaled(corner.size.width), scaled(corner.size.height)};
}

}  // namespace tactooth
