// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// F. N. Fritsch, J. Butland, "A method for constructing local monotone piecewise cubic interpolants", SIAM J. Sci.
// Stat. Comput. 5 (1984); here with the slopes of the first and last piece at the ends.
#include "instruments/modelling/smooth_curve.h"

#include <algorithm>

#include "geometry/util/assert.h"

namespace tactooth {

SmoothCurve::SmoothCurve(std::span<const Point> points) : points_(points.begin(), points.end()) {
    TACTOOTH_ASSERT(points.size() >= 2);
    TACTOOTH_ASSERT(std::ranges::adjacent_find(points, std::ranges::greater_equal{}, &Point::at) == points.end());
    const auto steepness = [&](std::size_t i) {
        return (points_[i + 1].value - points_[i].value) / (points_[i + 1].at - points_[i].at);
    };
    slopes_.push_back(steepness(0));
    for (std::size_t i = 1; i + 1 < points_.size(); ++i) {
        const double before = steepness(i - 1), after = steepness(i);
        slopes_.push_back(before * after > 0 ? 2 * before * after / (before + after) : 0);
    }
    slopes_.push_back(steepness(points_.size() - 2));
}

SmoothCurve::Sample SmoothCurve::operator()(double at) const {
    const Point &first = points_.front(), &last = points_.back();
    if (at <= first.at) return {first.value + slopes_.front() * (at - first.at), slopes_.front()};
    if (at >= last.at) return {last.value + slopes_.back() * (at - last.at), slopes_.back()};
    const auto after = std::ranges::upper_bound(points_, at, {}, &Point::at);
    const auto i = static_cast<std::size_t>(after - points_.begin()) - 1;
    const double h = points_[i + 1].at - points_[i].at, t = (at - points_[i].at) / h;
    const double a = points_[i].value, b = points_[i + 1].value, da = slopes_[i] * h, db = slopes_[i + 1] * h;
    const double cubic = 2 * (a - b) + da + db, square = 3 * (b - a) - 2 * da - db;
    return {((cubic * t + square) * t + da) * t + a, ((3 * cubic * t + 2 * square) * t + da) / h};
}

}  // namespace tactooth
