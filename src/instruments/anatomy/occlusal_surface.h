// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "instruments/anatomy/posterior_tooth.h"

namespace tactooth {

/// The occlusal surface of a posterior tooth: cusps, ridges and grooves, brought to the heights of the landmarks.
/// Refers to the plan.
class OcclusalSurface {
public:
    explicit OcclusalSurface(const PosteriorToothPlan& plan);

    /// Height over (x, y), without the grooves.
    [[nodiscard]] double height(double x, double y) const;

    /// Depth of the grooves and pits in it at (x, y).
    [[nodiscard]] double grooveDepth(double x, double y) const;

    /// A lower bound of its height without the grooves.
    [[nodiscard]] double lowest() const { return lowest_; }

private:
    [[nodiscard]] double form(double x, double y) const;

    const PosteriorToothPlan& plan_;
    Eigen::VectorXd lifts_;  // mm: one for each landmark
    double lowest_;
};

}  // namespace tactooth
