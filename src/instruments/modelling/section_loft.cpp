// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// F. N. Fritsch, J. Butland, "A method for constructing local monotone piecewise cubic interpolants", SIAM J. Sci.
// Stat. Comput. 5 (1984): no bulge between sections that the table does not have. Distance estimate: G. Taubin,
// "Distance approximations for rasterizing implicit curves", ACM Trans. Graph. 13 (1994), value over length of the
// gradient.
#include "instruments/modelling/section_loft.h"

#include <algorithm>
#include <cmath>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

enum Column { kPlusX, kMinusX, kPlusY, kMinusY, kSquareness, kCentreX, kCentreY };

}  // namespace

SectionLoft::SectionLoft(std::span<const Section> sections) {
    TACTOOTH_ASSERT(sections.size() >= 2);
    for (const Section& s : sections) {
        TACTOOTH_ASSERT(heights_.empty() || s.z > heights_.back());
        heights_.push_back(s.z);
        values_.push_back((Row() << s.plusX, s.minusX, s.plusY, s.minusY, s.squareness, s.x, s.y).finished());
    }
    slopes_.assign(values_.size(), Row::Zero());
    for (std::size_t i = 1; i + 1 < values_.size(); ++i) {
        const Row before = (values_[i] - values_[i - 1]) / (heights_[i] - heights_[i - 1]);
        const Row after = (values_[i + 1] - values_[i]) / (heights_[i + 1] - heights_[i]);
        for (int c = 0; c < kColumns; ++c) {
            if (before[c] * after[c] > 0) slopes_[i][c] = 2 * before[c] * after[c] / (before[c] + after[c]);
        }
    }
}

SectionLoft::Sample SectionLoft::sample(double z) const {
    if (z <= heights_.front()) return {values_.front(), Row::Zero()};
    if (z >= heights_.back()) return {values_.back(), Row::Zero()};
    const auto i = static_cast<std::size_t>(std::ranges::upper_bound(heights_, z) - heights_.begin()) - 1;
    const double h = heights_[i + 1] - heights_[i], t = (z - heights_[i]) / h;
    const Row &a = values_[i], &b = values_[i + 1];
    const Row da = slopes_[i] * h, db = slopes_[i + 1] * h;
    const Row cubic = 2 * (a - b) + da + db, square = 3 * (b - a) - 2 * da - db;
    return {((cubic * t + square) * t + da) * t + a, ((3 * cubic * t + 2 * square) * t + da) / h};
}

double SectionLoft::operator()(const Vec3& point) const {
    const auto [value, slope] = sample(point.z());
    const double dx = point.x() - value[kCentreX], dy = point.y() - value[kCentreY];
    const int alongX = dx >= 0 ? kPlusX : kMinusX, alongY = dy >= 0 ? kPlusY : kMinusY;
    const double a = value[alongX], b = value[alongY], n = value[kSquareness];
    const double u = std::abs(dx) / a, v = std::abs(dy) / b;
    const double un = std::pow(u, n), vn = std::pow(v, n);
    const double g = std::pow(un + vn, 1 / n);
    constexpr double kAxis = 1e-6;  // this near to the axis the outline's gradient has no direction
    if (g < kAxis) return -std::min(a, b);
    const double gu = u > 0 ? un / u * g / (un + vn) : 0, gv = v > 0 ? vn / v * g / (un + vn) : 0;
    // Slopes as at the surface: beyond it, those of a thin end would make far points look near.
    const double onto = 1 / std::max(g, 1.0);
    const double gz = gu * (onto * u * slope[alongX] + std::copysign(slope[kCentreX], dx)) / a +
                      gv * (onto * v * slope[alongY] + std::copysign(slope[kCentreY], dy)) / b;
    const double estimate = (g - 1) / std::sqrt(gu * gu / (a * a) + gv * gv / (b * b) + gz * gz);
    return std::max(estimate, -std::min(a, b));  // no inner point is farther from the outline than that
}

Section SectionLoft::at(double z) const {
    const Row row = sample(z).value;
    return {z, row[kPlusX], row[kMinusX], row[kPlusY], row[kMinusY], row[kSquareness], row[kCentreX], row[kCentreY]};
}

}  // namespace tactooth
