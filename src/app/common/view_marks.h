// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "view/camera/camera.h"
#include "view/render/image.h"

class QPainter;
class QRectF;

// What a picture of a tooth says about itself: its scale, and where its directions are.

namespace tactooth {

/// A bar of a round length.
struct ScaleBar {
    double millimetres = 1;
    double pixels = 0;
};
/// The longest bar of 1, 2 or 5 times a power of ten that is at most `widest` pixels; both positive.
[[nodiscard]] ScaleBar scaleBar(double pixelsPerMm, double widest);

/// The letter of a direction of the tooth (B, L, M, D, O, A), at the edge of the picture.
struct AxisLetter {
    char letter = ' ';
    bool visible = false;       ///< false: the direction is nearly along the line of sight
    Vec2 place = Vec2::Zero();  ///< of its middle, pixels from the picture's upper left corner
};
/// Their order.
inline constexpr std::array kAxisLetterNames = {'B', 'L', 'M', 'D', 'O', 'A'};
inline constexpr std::size_t kAxisLetters = kAxisLetterNames.size();
/// `margin`: from the edge to the middle of a letter, pixels.
[[nodiscard]] std::array<AxisLetter, kAxisLetters> axisLetters(const Camera& camera, ImageSize size, double mesialX,
                                                               double margin);

/// Draws the bar with its length into `box`, white on a dark ground. `box` is at least as wide as the bar.
void drawScaleBar(QPainter& painter, const QRectF& box, const ScaleBar& bar);
/// Draws one letter, white on a dark disc that fills `box`.
void drawAxisLetter(QPainter& painter, const QRectF& box, char letter);

/// Draws scale bar and letters into a picture. `pixelsPerMm`: at the depth of the tooth. Needs no display.
void drawViewMarks(Image& image, const Camera& camera, double mesialX, double pixelsPerMm);

}  // namespace tactooth
