// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/mouth/neck_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/util/assert.h"
#include "instruments/modelling/blend.h"

namespace tactooth {

std::vector<NeckCurve::Knot> NeckCurve::rightSide(std::span<const Pose> toothInMouth) {
    TACTOOTH_ASSERT(toothInMouth.size() >= 2);
    std::vector<Knot> knots;
    for (const Pose& pose : toothInMouth) {
        const Vec3 neck(std::abs(pose.position.x()), pose.position.y(), pose.position.z());
        const double step = knots.empty() ? neck.x() : (neck - knots.back().neck).norm();
        knots.push_back({(knots.empty() ? 0 : knots.back().s) + step, neck});
    }
    return knots;
}

SmoothCurve NeckCurve::coordinate(const std::vector<Knot>& right, int axis) {
    std::vector<SmoothCurve::Point> points;
    for (auto knot = right.rbegin(); knot != right.rend(); ++knot)
        points.push_back({-knot->s, axis == 0 ? -knot->neck.x() : knot->neck[axis]});
    for (const Knot& knot : right) points.push_back({knot.s, knot.neck[axis]});
    return SmoothCurve(points);
}

NeckCurve::NeckCurve(std::span<const Pose> toothInMouth) : NeckCurve(rightSide(toothInMouth)) {}

NeckCurve::NeckCurve(const std::vector<Knot>& right)
    : half_(right.back().s), x_(coordinate(right, 0)), y_(coordinate(right, 1)), z_(coordinate(right, 2)) {
    constexpr double kBeyond = 25;  // mm: the curve goes straight on behind the last tooth
    constexpr int kSamples = 160;
    for (int i = 0; i <= kSamples; ++i) {
        const double s = (half_ + kBeyond) * (2.0 * i / kSamples - 1);
        samples_.push_back({s, at(s)});
    }
}

NeckCurve::Place NeckCurve::at(double s) const {
    const auto x = x_(s), y = y_(s), z = z_(s);
    // Along the curve +x is to the right, so that forward is its left normal.
    return {Vec3(x.value, y.value, z.value), Vec3(-y.slope, x.slope, 0).normalized()};
}

double NeckCurve::lengthTo(double x) const {
    const auto found = std::ranges::find_if(
        samples_, [&](const Sample& sample) { return sample.s >= 0 && sample.place.neck.x() >= x; });
    return found != samples_.end() ? found->s : samples_.back().s;
}

double NeckCurve::insideDistance(const Vec3& p) const {
    struct Nearest {
        double squared = std::numeric_limits<double>::max(), outward = 0;
    };
    std::array<Nearest, 2> sides;  // left, right
    for (const Sample& sample : samples_) {
        const Vec3 from(p.x() - sample.place.neck.x(), p.y() - sample.place.neck.y(), 0);
        Nearest& side = sides[sample.s < 0 ? 0 : 1];
        if (from.squaredNorm() < side.squared) side = {from.squaredNorm(), from.dot(sample.place.outward)};
    }
    const auto inside = [](const Nearest& side) { return std::copysign(std::sqrt(side.squared), -side.outward); };
    constexpr double kBlend = 6;  // mm: no crease where both sides are equally near
    return smoothUnion(inside(sides[0]), inside(sides[1]), kBlend);
}

}  // namespace tactooth
