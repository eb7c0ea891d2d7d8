// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/simulation/pulp_distance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "collision/bvh/closest_point.h"

namespace tactooth {
namespace {

constexpr double kHeadPart = 2.5;  // mm of the head above the tip that can be nearest to the pulp
constexpr double kRings = 0.2;     // mm between two rings of places on the head, at most
constexpr int kAround = 8;         // places around the axis

/// Calls `visit` with places of the head's surface until it returns true. Returns whether it did. The corners of the
/// profile are among them, unless they are close together.
template <class Visit>
bool anyPlace(const RevolutionEnvelope& head, const Pose& pose, const Visit& visit) {
    const auto anyOf = [&](const Vec2& ring) {  // radius, z
        const int places = ring.x() > 0 ? kAround : 1;
        for (int i = 0; i < places; ++i) {
            const double angle = 2 * std::numbers::pi * i / places;
            if (visit(pose * Vec3(ring.x() * std::cos(angle), ring.x() * std::sin(angle), ring.y()))) return true;
        }
        return false;
    };
    Vec2 last(head.profile().front().radius, head.bottom());
    if (anyOf(last)) return true;
    for (const RevolutionEnvelope::ProfilePoint& corner : head.profile()) {
        const Vec2 next(corner.radius, corner.z);
        const int steps = static_cast<int>(std::ceil((next - last).norm() / kRings));
        if ((next - last).norm() < kRings / 2) continue;
        const Vec2 start = last;
        for (int i = 1; i <= steps; ++i) {
            last = start + static_cast<double>(i) / steps * (next - start);
            if (last.y() > head.bottom() + kHeadPart) return false;
            if (anyOf(last)) return true;
        }
    }
    return false;
}

bool isPulp(const LayeredTooth& tooth, const LayeredTooth::Layer& layer) {
    return tooth.materials().hasRole(layer.material, MaterialRole::Pulp);
}

}  // namespace

std::optional<double> distanceToPulp(const LayeredTooth& tooth, const RevolutionEnvelope& head, const Pose& pose,
                                     double within) {
    std::optional<double> least;
    for (const LayeredTooth::Layer& layer : tooth.layers()) {
        if (!isPulp(tooth, layer)) continue;
        (void)anyPlace(head, pose, [&](const Vec3& place) {
            const auto closest = closestPoint(*layer.part, place, least ? std::abs(*least) : within);
            if (!closest) return false;
            const bool isIn = closest->distance < kNearPulp && contains(*layer.part, place);
            const double distance = isIn ? -closest->distance : closest->distance;
            least = std::min(least.value_or(distance), distance);
            return false;
        });
    }
    return least;
}

bool isNearPulp(const LayeredTooth& tooth, const RevolutionEnvelope& head, const Pose& pose, double within) {
    const Vec3 middle = pose * Vec3(0, 0, head.bottom() + kHeadPart / 2);
    const double reach = std::hypot(kHeadPart / 2, head.maxRadius()) + within;
    return std::ranges::any_of(tooth.layers(), [&](const LayeredTooth::Layer& layer) {
        if (!isPulp(tooth, layer) || !closestPoint(*layer.part, middle, reach)) return false;
        return anyPlace(head, pose,
                        [&](const Vec3& place) { return closestPoint(*layer.part, place, within).has_value(); });
    });
}

}  // namespace tactooth
