// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/hand_instruments.h"

#include <vector>

#include "instruments/modelling/tube.h"

namespace tactooth {
namespace {

constexpr int kSides = 24;
constexpr double kHandle = 3.0;  // mm, radius

/// The handle from the end of the shank: a cone, a cylinder, a rounded end.
void addHandle(std::vector<TubePoint>& points, const Vec3& along) {
    const TubePoint shank = points.back();
    constexpr double kCone = 7, kLength = 100, kRound = 1.2;  // mm
    points.push_back({shank.centre + kCone * along, kHandle});
    points.push_back({shank.centre + kLength * along, kHandle});
    points.push_back({shank.centre + (kLength + 0.7 * kRound) * along, kHandle - 0.3 * kRound});
    points.push_back({shank.centre + (kLength + kRound) * along, kHandle - kRound});
}

}  // namespace

TriangleMesh makeExplorer() {
    const std::vector<TubePoint> hook = {{{0, 0, 0}, 0.08},     {{1.0, 0, -0.55}, 0.17}, {{2.4, 0, -0.5}, 0.25},
                                         {{3.8, 0, 0.7}, 0.33}, {{4.4, 0, 2.8}, 0.42},   {{3.8, 0, 5.2}, 0.52},
                                         {{2.5, 0, 7.8}, 0.65}, {{1.3, 0, 10.8}, 0.80},  {{0.75, 0, 14.5}, 0.95},
                                         {{0.6, 0, 20}, 1.15},  {{0.6, 0, 26}, 1.4}};
    constexpr int kSteps = 6;
    std::vector<TubePoint> points = smoothed(hook, kSteps);
    addHandle(points, Vec3::UnitZ());
    return tube(points, kSides);
}

TriangleMesh makePeriodontalProbe() {
    constexpr double kTip = 0.25, kWidening = 0.008;             // mm: radius; growth for each mm
    constexpr double kRing = 0.12, kDepth = 0.04, kEdge = 0.02;  // mm: half width, depth and edge of a mark
    std::vector<TubePoint> points = {{{0, 0, 0}, 0.6 * kTip}, {{0, 0, 0.06}, 0.9 * kTip}, {{0, 0, 0.16}, kTip}};
    for (const double mark : kProbeMarks) {
        const double radius = kTip + kWidening * mark;
        points.push_back({{0, 0, mark - kRing - kEdge}, radius});
        points.push_back({{0, 0, mark - kRing}, radius - kDepth});
        points.push_back({{0, 0, mark + kRing}, radius - kDepth});
        points.push_back({{0, 0, mark + kRing + kEdge}, radius});
    }
    const std::vector<TubePoint> shank = {{{0, 0, 12}, 0.36},  {{0.25, 0, 14}, 0.45}, {{1.5, 0, 16.6}, 0.6},
                                          {{4.2, 0, 19}, 0.8}, {{8.2, 0, 21.2}, 1.0}, {{13, 0, 23.6}, 1.25},
                                          {{18, 0, 26.1}, 1.4}};
    constexpr int kSteps = 6;
    const std::vector<TubePoint> curve = smoothed(shank, kSteps);
    points.insert(points.end(), curve.begin(), curve.end());
    addHandle(points, Vec3(5, 0, 2.5).normalized());
    return tube(points, kSides);
}

}  // namespace tactooth
