// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/util/vec.h"

namespace tactooth {

/// The outline of a body at one height: an oval with a separate half axis toward each side, mm. On a tooth, +x is
/// mesial and +y buccal.
struct Section {
    double z = 0;
    double plusX = 1, minusX = 1, plusY = 1, minusY = 1;  ///< half axes
    double squareness = 2;  ///< 2: ellipse; more: toward a rectangle; less: toward a rhombus
    double x = 0, y = 0;    ///< centre
};

/// A round section.
[[nodiscard]] constexpr Section circle(double z, double radius, double x = 0, double y = 0) {
    return {z, radius, radius, radius, radius, 2, x, y};
}

/// An infinite body through sections at increasing heights, smooth between them; beyond the first and last section it
/// continues with that section.
class SectionLoft {
public:
    explicit SectionLoft(std::span<const Section> sections);

    /// About the distance (first order) to the surface, negative inside.
    [[nodiscard]] double operator()(const Vec3& point) const;

    /// The section at a height.
    [[nodiscard]] Section at(double z) const;

private:
    static constexpr int kColumns = 7;
    using Row = Eigen::Array<double, kColumns, 1>;
    struct Sample {
        Row value, slope;
    };
    [[nodiscard]] Sample sample(double z) const;

    std::vector<double> heights_;
    std::vector<Row> values_, slopes_;
};

}  // namespace tactooth
