// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>

#include "app/gui/input/viewport.h"
#include "collision/bvh/surface.h"

namespace tactooth {

/// What the mouse does on the tooth in place of the bur, while it is given to the view. Pixels are those of the
/// picture.
class SurfaceTool {
public:
    SurfaceTool() = default;
    SurfaceTool(const SurfaceTool&) = delete;
    SurfaceTool& operator=(const SurfaceTool&) = delete;
    virtual ~SurfaceTool() = default;

    /// The left button, or the key that presses the bur, goes down and up.
    virtual void press(const Surface& surface, const Viewport& picture, const Vec2& pixel) = 0;
    virtual void release() = 0;
    virtual void move(const Surface& surface, const Viewport& picture, const Vec2& pixel) = 0;
    /// A click of the right button, without turning the tooth.
    virtual void clickRight(const Viewport& picture, const Vec2& pixel) = 0;
    /// Whether it obeys these keys; if so, they do nothing else in the view.
    [[nodiscard]] virtual bool wants(const QKeySequence& keys) const = 0;
    virtual void obey(const QKeySequence& keys) = 0;
};

}  // namespace tactooth
