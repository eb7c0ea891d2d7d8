// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/replay/recorded_eye.h"

#include <algorithm>
#include <cmath>

namespace tactooth {

std::optional<Vec3> firstEye(const SessionTrack& track) {
    const std::vector<MirrorMoment> mirror = track.mirror();
    const auto first = std::ranges::find_if(mirror, [](const MirrorMoment& each) { return each.sight.isShown; });
    if (first == mirror.end()) return std::nullopt;
    return first->sight.eyePlace();
}

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
