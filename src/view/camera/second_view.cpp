// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/camera/second_view.h"

#include <algorithm>

namespace tactooth {

CornerRectangle secondViewRectangle(ImageSize picture) {
    constexpr double kShare = 0.3;     // of the picture's width, but at most ...
    constexpr double kHighest = 0.4;   // ... of its height
    constexpr double kMargin = 0.015;  // of the picture's height
    const double width = std::min(kShare * picture.width, kHighest * kSecondViewAspect * picture.height);
    const auto pixels = [](double length) { return std::max(1, static_cast<int>(length)); };
    const ImageSize size{pixels(width), pixels(width / kSecondViewAspect)};
    const int margin = static_cast<int>(kMargin * picture.height);
    return {std::max(0, picture.width - size.width - margin), margin, size};
}

}  // namespace tactooth
