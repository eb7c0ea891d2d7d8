// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/crown/axial_walls.h"

#include <algorithm>

#include "assessment/crown/finish_profile.h"
#include "geometry/util/degree.h"

namespace tactooth {
namespace {

constexpr double kSides = 0.6, kBuccal = 0.9;  // sine of the angle round the axis: there the buccal wall begins, is all

}  // namespace

AxialWalls::AxialWalls(const CrownOutline& crown, const FinishLine& line)
    : width_(crown.width),
      tipRadius_(crown.tipRadius),
      taper_(crown.taper * kDegree),
      buccalTaper_(crown.buccalTaper * kDegree),
      axis_(line.axis()),
      aside_(line.aside()),
      middle_(line.middle()) {}

AxialWalls::Taper AxialWalls::taperAt(const Vec3& place) const {
    Vec3 from = place - middle_;
    from -= axis_.dot(from) * axis_;
    const double radius = from.norm();
    if (taper_ == buccalTaper_ || radius < 1e-9) return {taper_, Vec3::Zero()};
    const double sine = aside_.dot(from) / radius;
    const double share = std::clamp((sine - kSides) / (kBuccal - kSides), 0.0, 1.0);
    const double angle = taper_ + (buccalTaper_ - taper_) * share * share * (3 - 2 * share);
    const double slope = (buccalTaper_ - taper_) * 6 * share * (1 - share) / (kBuccal - kSides);
    return {angle, slope / radius * (aside_ - sine / radius * from)};
}

RemovedBody::Depth AxialWalls::outside(const Vec3& place, const FinishLine::Place& at) const {
    const Taper taper = taperAt(place);
    const Vec2 flat(at.inside, at.above);
    const auto [height, slope] = FinishProfile(width_, taper.angle, tipRadius_).above(flat);
    Vec3 gradient = slope.x() * at.inward + slope.y() * at.upward;
    if (taper.gradient != Vec3::Zero()) {
        constexpr double kLittle = 1e-5;  // rad
        const double more = FinishProfile(width_, taper.angle + kLittle, tipRadius_).above(flat).value;
        gradient += (more - height) / kLittle * taper.gradient;
    }
    return {height / std::max(1.0, gradient.norm()), gradient};
}

}  // namespace tactooth
