// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/camera/magnifier.h"

#include <algorithm>
#include <cmath>

namespace tactooth {

CornerRectangle magnifierRectangle(ImageSize picture) {
    constexpr double kShare = 0.4;     // of the shorter side
    constexpr double kMargin = 0.015;  // of the picture's height
    const int side = std::max(1, static_cast<int>(kShare * std::min(picture.width, picture.height)));
    const int margin = static_cast<int>(kMargin * picture.height);
    return {margin, margin, {side, side}};
}

Camera magnifierCamera(const Camera& camera, ImageSize picture, const Vec3& place) {
    Camera near = camera;
    near.lensShift = 0;
    const Vec3 ahead = camera.cameraInWorld.rotation * -Vec3::UnitZ();
    const Vec3 toPlace = place - camera.cameraInWorld.position;
    const double share = magnifierRectangle(picture).size.height / (kMagnification * picture.height);
    // A picture square on the line to `place` shows it a little larger than one that has it beside its middle.
    const double aslant = toPlace.norm() > 0 ? std::max(0.1, ahead.dot(toPlace) / toPlace.norm()) : 1;
    near.fieldOfView = 2 * std::atan(share * aslant * std::tan(camera.fieldOfView / 2));
    if (toPlace.norm() > 0) {
        near.cameraInWorld.rotation =
            (shortestRotation(ahead, toPlace.normalized()) * camera.cameraInWorld.rotation).normalized();
    }
    return near;
}

}  // namespace tactooth
