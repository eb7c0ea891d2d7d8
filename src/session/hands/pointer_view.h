// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/ray.h"

namespace tactooth {

/// The picture that the mouse points into, seen by a camera in the tooth's frame.
class PointerView {
public:
    PointerView() = default;
    PointerView(const PointerView&) = default;
    PointerView& operator=(const PointerView&) = default;
    virtual ~PointerView() = default;

    /// The line of sight through `pixel`: origin at the picture's top left corner, y down.
    [[nodiscard]] virtual Ray rayThrough(const Vec2& pixel) const = 0;
    /// The axes of what the eye sees, in the tooth's frame: to the right, up, and toward the eye. In a mirror they are
    /// left-handed.
    [[nodiscard]] virtual Mat3 eyeAxes() const = 0;
};

}  // namespace tactooth
