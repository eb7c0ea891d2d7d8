// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/hands/pointer_view.h"
#include "view/camera/camera.h"

namespace tactooth {

/// The window's picture as the mouse points into it.
class Viewport final : public PointerView {
public:
    Viewport() = default;
    Viewport(const Camera& camera, ImageSize size) : camera_(camera), size_(size) {}

    [[nodiscard]] Ray rayThrough(const Vec2& pixel) const override {
        return tactooth::rayThrough(camera_, size_, pixel);
    }
    [[nodiscard]] Mat3 eyeAxes() const override { return camera_.cameraInWorld.rotation.toRotationMatrix(); }

    [[nodiscard]] const Camera& camera() const { return camera_; }
    [[nodiscard]] ImageSize size() const { return size_; }  ///< pixels

private:
    Camera camera_;
    ImageSize size_;
};

}  // namespace tactooth
