// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "view/camera/camera.h"

namespace tactooth {

/// A tooth of the chart, seen from occlusal, as simple lines. Chart frame: +x to the right of the picture, which is the
/// patient's left, +y down, mm.
struct ChartTooth {
    int fdi = 0;
    Vec2 centre = Vec2::Zero();
    Vec2 outward = Vec2::Zero();           ///< unit, to the cheek or the lip: there is room for the number
    std::vector<Vec2> outline;             ///< closed
    std::vector<std::vector<Vec2>> lines;  ///< incisal edge or fissures, open
};

/// Both arches, the upper one above with the incisors at the top, the lower one below with them at the bottom.
struct ToothChartLayout {
    static constexpr std::size_t kTeeth = 32;
    /// Row by row from left to right: 18 to 11, 21 to 28, then 48 to 41, 31 to 38.
    std::array<ChartTooth, kTeeth> teeth;
    Vec2 size = Vec2::Zero();  ///< of the chart with room for the numbers around it
};

[[nodiscard]] ToothChartLayout toothChartLayout();

enum class ChartStep { Left, Right, Up, Down };

/// The tooth that an arrow key goes to from `fdi`: along the row, or to the opposing jaw. At an end it stays.
[[nodiscard]] int toothBeside(int fdi, ChartStep step);

}  // namespace tactooth
