// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "session/hands/instrument_poses.h"
#include "session/hands/pointer_view.h"

namespace tactooth::test {

/// A pinhole camera that looks at the origin's neighbourhood, 1000 x 800 pixels.
class Pinhole final : public PointerView {
public:
    explicit Pinhole(const ViewDirection& view = {1.2, 0.8}) {
        constexpr double kDistance = 60;  // mm
        const Vec3 back = directionToEye(view);
        const Vec3 right = Vec3::UnitZ().cross(back).normalized();
        Mat3 axes;
        axes << right, back.cross(right), back;
        rotation_ = Quat(axes);
        eye_ = kDistance * back;
    }
    [[nodiscard]] Ray rayThrough(const Vec2& pixel) const override {
        const Vec3 inCamera((pixel.x() - 500) / kFocal, (400 - pixel.y()) / kFocal, -1);
        return {eye_, (rotation_ * inCamera).normalized()};
    }
    [[nodiscard]] Mat3 eyeAxes() const override { return rotation_.toRotationMatrix(); }
    [[nodiscard]] Vec2 pixelOf(const Vec3& point) const {
        const Vec3 inCamera = rotation_.conjugate() * (point - eye_);
        return {500 - kFocal * inCamera.x() / inCamera.z(), 400 + kFocal * inCamera.y() / inCamera.z()};
    }
    [[nodiscard]] const Vec3& eye() const { return eye_; }

private:
    static constexpr double kFocal = 1800;  // pixels
    Quat rotation_;
    Vec3 eye_;
};

}  // namespace tactooth::test
