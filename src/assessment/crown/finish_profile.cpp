// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/crown/finish_profile.h"

#include <algorithm>
#include <cmath>

#include "geometry/util/assert.h"

namespace tactooth {

FinishProfile::FinishProfile(double width, double taper, double radius) : taper_(taper), radius_(radius) {
    TACTOOTH_ASSERT(width > 0 && taper > 0 && radius >= 0);
    // The wall leaves the height of the bur's end at x = width, and the end touches it.
    const double x = width - radius * (1 - std::sin(taper)) / std::cos(taper);
    floorEnd_ = std::max(0.0, x);
    const double missing = std::min(x, 0.0);
    TACTOOTH_ASSERT(-missing <= radius);
    centre_ = Vec2(x, std::sqrt(std::max(0.0, radius * radius - missing * missing)));
    foot_ = centre_ + radius * Vec2(std::cos(taper), -std::sin(taper));
}

FinishProfile::Height FinishProfile::above(const Vec2& place) const {
    const Vec2 along(std::sin(taper_), std::cos(taper_)), outward(-std::cos(taper_), std::sin(taper_));
    // Of the wall.
    const double up = std::max(0.0, (place - foot_).dot(along));
    Vec2 nearest = foot_ + up * along, normal = outward;
    double least = (place - nearest).norm();
    const auto take = [&](const Vec2& point, const Vec2& direction) {
        const double distance = (place - point).norm();
        if (distance >= least) return;
        least = distance;
        nearest = point;
        normal = direction;
    };
    take(Vec2(std::min(place.x(), floorEnd_), 0), Vec2::UnitY());
    const Vec2 from = place - centre_;
    if (radius_ > 0 && from.norm() > 0) {
        // Of the arc, between the end of the floor and the foot of the wall.
        const double first = std::atan2(-centre_.y(), floorEnd_ - centre_.x()), last = -taper_;
        const double angle = std::atan2(from.y(), from.x());
        if (angle >= first && angle <= last) {
            const Vec2 direction(std::cos(angle), std::sin(angle));
            take(centre_ + radius_ * direction, -direction);
        }
    }
    double profile = 0;
    if (place.x() > foot_.x()) {
        profile = foot_.y() + (place.x() - foot_.x()) / std::tan(taper_);
    } else if (place.x() > floorEnd_ && radius_ > 0) {
        const double x = place.x() - centre_.x();
        profile = centre_.y() - std::sqrt(std::max(0.0, radius_ * radius_ - x * x));
    }
    const double sign = place.y() > profile ? 1 : -1;
    if (least > 1e-6) normal = sign / least * (place - nearest);
    return {sign * least, normal};
}

}  // namespace tactooth
