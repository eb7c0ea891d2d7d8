// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWheelEvent>
#include <QWidget>
#include <algorithm>
#include <cmath>

#include "session/hands/pointer_view.h"
#include "view/camera/camera.h"

// What pictures of a scene share in how they take the mouse. A pixel is one of the picture, which may be finer than the
// desktop's.

namespace tactooth {

inline constexpr double kZoomStep = 0.88;  ///< factor of the distance for one notch, or one press of a key
inline constexpr double kMirrorStep = 1;   ///< mm that the mirror comes nearer, likewise

/// Of the picture that fills the widget.
[[nodiscard]] inline ImageSize pictureSize(const QWidget& widget) {
    const double ratio = widget.devicePixelRatioF();
    return {std::max(1, static_cast<int>(std::lround(widget.width() * ratio))),
            std::max(1, static_cast<int>(std::lround(widget.height() * ratio)))};
}

/// The pixel at a position in the widget.
[[nodiscard]] inline Vec2 pixelAt(const QWidget& widget, const QPointF& position) {
    return Vec2(position.x(), position.y()) * widget.devicePixelRatioF();
}

/// Notches that the wheel was turned.
[[nodiscard]] inline double notchesOf(const QWheelEvent& event) {
    constexpr double kNotch = 120;             // eighths of a degree
    const QPoint turned = event.angleDelta();  // with Alt a wheel turns sideways
    return (turned.y() != 0 ? turned.y() : turned.x()) / kNotch;
}

}  // namespace tactooth
