// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/recorded_eye.h"

#include <cmath>

namespace tactooth {

OrbitCamera lookingFrom(OrbitCamera camera, const Vec3& eye, ImageSize picture) {
    constexpr double kNearest = 1, kAside = 1e-3;  // mm; of the distance
    const Vec3 line = eye - camera.target();
    const double distance = line.norm(), aside = std::hypot(line.x(), line.y());
    if (!(distance > kNearest)) return camera;
    // Straight above the target each turn of the picture has the same eye.
    const double azimuth = aside > kAside * distance ? std::atan2(line.y(), line.x()) : camera.direction().azimuth;
    camera.setView(OrbitCamera::Direction{azimuth, std::atan2(line.z(), aside)});
    camera.zoom(distance / camera.distance(), {picture.width / 2.0, picture.height / 2.0}, picture);
    return camera;
}

}  // namespace tactooth
