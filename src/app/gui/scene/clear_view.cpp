// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/clear_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/util/degree.h"
#include "session/control/surface_ray.h"

namespace tactooth {
namespace {

bool isSeen(const Obstacles& obstacles, const Pose& tool, const Vec3& place, const Vec3& toEye) {
    if (firstHit(obstacles.tooth, {place, toEye})) return false;
    if (obstacles.handpiece == nullptr) return true;
    const Quat toTool = tool.rotation.conjugate();
    return !firstHit(*obstacles.handpiece, {toTool * (place - tool.position), toTool * toEye});
}

/// The place of the surface below or above `place`, lifted a little, because a place in the surface hides itself.
Vec3 onSurface(const Surface& tooth, const Vec3& place) {
    constexpr double kHigher = 5, kLift = 0.1;  // mm; a cusp is not that high above its fossa
    const auto down = firstHit(tooth, {place + kHigher * Vec3::UnitZ(), -Vec3::UnitZ()});
    const double up = down && *down < 2 * kHigher ? kHigher - *down : 0;
    return place + (up + kLift) * Vec3::UnitZ();
}

/// Nearest to `usual` first.
std::vector<ViewDirection> directionsAround(const ViewDirection& usual) {
    constexpr double kSteepest = 80 * kDegree;
    std::vector<ViewDirection> directions;
    for (const double aside : {0, 15, -15, 30, -30, 45, -45}) {
        for (double up = usual.elevation; up <= kSteepest; up += 5 * kDegree) {
            directions.push_back({usual.azimuth + aside * kDegree, up});
        }
    }
    const Vec3 wanted = directionToEye(usual);
    std::ranges::stable_sort(directions, std::greater(),
                             [&](const ViewDirection& view) { return wanted.dot(directionToEye(view)); });
    return directions;
}

}  // namespace

double seenShare(const Obstacles& obstacles, const Pose& tool, const Vec3& toEye) {
    constexpr std::array kRings = {0.0, 0.5, 1.0};  // mm
    constexpr int kAround = 8;
    int seen = 0, all = 0;
    for (const double ring : kRings) {
        for (int i = 0; i < (ring > 0 ? kAround : 1); ++i) {
            const double angle = 2 * std::numbers::pi * i / kAround;
            const Vec3 aside(ring * std::cos(angle), ring * std::sin(angle), 0);
            ++all;
            if (isSeen(obstacles, tool, onSurface(obstacles.tooth, tool.position + aside), toEye)) ++seen;
        }
    }
    return static_cast<double>(seen) / all;
}

ViewDirection clearView(const Obstacles& obstacles, std::span<const Pose> tools, ViewDirection usual) {
    constexpr double kEnough = 0.9;
    ViewDirection best = usual;
    double most = -1;
    for (const ViewDirection& view : directionsAround(usual)) {
        double least = 1;
        for (const Pose& tool : tools) least = std::min(least, seenShare(obstacles, tool, directionToEye(view)));
        if (least >= kEnough) return view;
        if (least > most) most = least, best = view;
    }
    return best;
}

}  // namespace tactooth
