// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/cavity_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "session/control/surface_ray.h"

namespace tactooth {
namespace {

constexpr double kSteepest = 15 * std::numbers::pi / 180;  // rad from the axis: more, and slopes look too narrow
constexpr int kSteps = 12;                                 // from the dentist's direction to the axis
constexpr double kWidth = 0.8;                             // mm around the path that the outline may take
constexpr double kLift = 0.03;                             // mm above the surface, so that it does not hide itself
constexpr double kOutside = 60;                            // mm

/// Places on the surface along the path and beside it.
std::vector<Vec3> placesOn(const PreparationPlan& plan, const LayeredTooth& tooth, const Surface& outer) {
    std::vector<Vec3> places;
    const Vec3 u = plan.outward.unitOrthogonal();
    const Vec3 v = plan.outward.cross(u);
    constexpr std::size_t kMostAlong = 12;  // places of a path
    if (plan.crown) return places;          // seen from any direction that looks into it
    for (const BurPath& path : burPaths(plan, tooth, outer.base)) {
        const std::size_t step = std::max<std::size_t>(1, path.places.size() / kMostAlong);
        for (std::size_t i = 0; i < path.places.size(); i += step) {
            const Vec3& middle = path.places[i];
            for (const Vec3& aside : {Vec3(Vec3::Zero()), Vec3(u), Vec3(-u), Vec3(v), Vec3(-v)}) {
                const Vec3 start = middle + kWidth * aside;
                const Vec3 above = start + (kOutside - plan.outward.dot(start)) * plan.outward;
                const auto hit = firstHit(outer, {above, -plan.outward});
                if (hit) places.emplace_back(above - (*hit - kLift) * plan.outward);
            }
        }
    }
    return places;
}

}  // namespace

ViewDirection viewOnto(const PreparationPlan& plan, const LayeredTooth& tooth, double mesialX) {
    const Surface surface{.base = tooth.ownOuter()};
    const std::vector<Vec3> places = placesOn(plan, tooth, surface);
    const Vec3 usual = directionToEye(dentistView(mesialX));
    Vec3 toEye = plan.outward;
    for (int i = 0; i < kSteps; ++i) {
        const double part = static_cast<double>(i) / kSteps;
        const Vec3 tried = ((1 - part) * usual + part * plan.outward).normalized();
        if (tried.dot(plan.outward) < std::cos(kSteepest)) continue;
        const bool seesAll = std::ranges::none_of(places, [&](const Vec3& place) {
            return firstHit(surface, {place, tried}).has_value();
        });
        if (!seesAll) continue;
        toEye = tried;
        break;
    }
    ViewDirection view;
    view.elevation = std::asin(std::clamp(toEye.z(), -1.0, 1.0));
    view.azimuth = std::atan2(toEye.y(), toEye.x());
    if (std::hypot(toEye.x(), toEye.y()) < 1e-6) view.azimuth = dentistView(mesialX).azimuth;  // from right above
    return view;
}

}  // namespace tactooth
