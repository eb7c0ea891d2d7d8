// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/anatomy/occlusal_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "instruments/anatomy/deviation.h"
#include "instruments/modelling/blend.h"

namespace tactooth {

void raiseLandmarks(PosteriorToothPlan& plan, double x, double y, double rise) {
    constexpr double kReach = 1.5;  // mm: the tip with its flanks and the upper half of its triangular ridge
    for (OcclusalLandmark& landmark : plan.landmarks) {
        const double left = bump(std::hypot(landmark.x - x, landmark.y - y), kReach);
        landmark.depth = std::max(0.0, landmark.depth - left * rise);
    }
}

void raiseLandmarks(PosteriorToothPlan& plan, const OcclusalRidge& ridge, double rise) {
    constexpr double kReach = 0.9;  // mm: the crest and the upper part of its slopes
    const Vec2 from(ridge.ax, ridge.ay), along = Vec2(ridge.bx, ridge.by) - from;
    for (OcclusalLandmark& landmark : plan.landmarks) {
        const Vec2 place(landmark.x, landmark.y);
        const double part = std::clamp((place - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
        const double left = bump((place - from - part * along).norm(), kReach);
        landmark.depth = std::max(0.0, landmark.depth - left * rise);
    }
}

TableWave::TableWave(std::mt19937& random, double shortest, double longest) {
    for (Wave& wave : waves_) {
        const double direction = deviation(random, std::numbers::pi);
        const double number = 2 * std::numbers::pi / numberBetween(random, shortest, longest);
        wave = {number * std::cos(direction), number * std::sin(direction), deviation(random, std::numbers::pi)};
    }
}

double TableWave::operator()(double x, double y) const {
    double sum = 0;
    for (const Wave& wave : waves_) sum += std::sin(wave.alongX * x + wave.alongY * y + wave.phase);
    return sum / static_cast<double>(waves_.size());
}

}  // namespace tactooth
