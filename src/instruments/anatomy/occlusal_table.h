// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Changes of the landmarks, cusps, ridges and grooves of a plan that keep them together.
#pragma once

#include <array>
#include <random>

#include "instruments/anatomy/posterior_tooth.h"

namespace tactooth {

/// Raises the landmarks around a place, most at the place itself; mm. None gets above the highest cusp.
void raiseLandmarks(PosteriorToothPlan& plan, double x, double y, double rise);

/// Raises those around a ridge.
void raiseLandmarks(PosteriorToothPlan& plan, const OcclusalRidge& ridge, double rise);

/// A smooth random function over the occlusal table, between -1 and 1.
class TableWave {
public:
    /// Wavelengths in mm, from `shortest` to `longest`.
    TableWave(std::mt19937& random, double shortest, double longest);

    [[nodiscard]] double operator()(double x, double y) const;

private:
    struct Wave {
        double alongX, alongY, phase;  ///< rad for each mm, rad
    };
    std::array<Wave, 2> waves_;
};

}  // namespace tactooth
