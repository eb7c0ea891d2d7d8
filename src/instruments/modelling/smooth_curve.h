// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

namespace tactooth {

/// A curve through points, monotone between two of them, so that it has no bulge that the points do not have; beyond
/// the first and last point it goes straight on.
class SmoothCurve {
public:
    struct Point {
        double at, value;
    };
    struct Sample {
        double value, slope;
    };

    /// At least two points with increasing `at`.
    explicit SmoothCurve(std::span<const Point> points);

    [[nodiscard]] Sample operator()(double at) const;

private:
    std::vector<Point> points_;
    std::vector<double> slopes_;
};

}  // namespace tactooth
