// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/spin_blur.h"

#include <algorithm>

namespace tactooth {

float spinBlur(double speedRpm, const BurEdge& edge) {
    constexpr double kGrains = 40;               // around a diamond bur of 1.4 mm with grains of 0.1 mm
    constexpr double kPicturesPerMinute = 1500;  // 25 a second
    const double edges = edge.flutes > 0 ? edge.flutes : kGrains;
    return static_cast<float>(std::clamp(speedRpm * edges / kPicturesPerMinute, 0.0, 1.0));
}

}  // namespace tactooth
