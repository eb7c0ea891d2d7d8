// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>

#include "view/render/image.h"

namespace tactooth {

/// The same pixels for Qt to paint on, without a copy: `image` outlives the result.
[[nodiscard]] inline QImage viewOf(Image& image) {
    return {reinterpret_cast<uchar*>(image.pixels.data()), image.size.width, image.size.height,
            QImage::Format_RGBA8888};
}
/// The same to read.
[[nodiscard]] inline QImage viewOf(const Image& image) {
    return {reinterpret_cast<const uchar*>(image.pixels.data()), image.size.width, image.size.height,
            QImage::Format_RGBA8888};
}

}  // namespace tactooth
