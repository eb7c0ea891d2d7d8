// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/hand_instruments.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/util/assert.h"
#include "geometry/util/pose.h"
#include "instruments/messages.h"
#include "instruments/modelling/tube.h"

namespace tactooth {
namespace {

constexpr double kHandle = 3.0;  // mm, radius

/// How finely an instrument is modelled.
struct Detail {
    int sides;
    int steps;    // for each interval of the curve of its shank
    bool handle;  // and the rings of the probe
};
constexpr Detail kFine{24, 6, true};
constexpr Detail kCoarse{8, 1, false};

/// The handle from the end of the shank: a cone, a cylinder, a rounded end.
void addHandle(std::vector<TubePoint>& points, const Vec3& along) {
    const TubePoint shank = points.back();
    constexpr double kCone = 7, kLength = 100, kRound = 1.2;  // mm
    points.push_back({shank.centre + kCone * along, kHandle});
    points.push_back({shank.centre + kLength * along, kHandle});
    points.push_back({shank.centre + (kLength + 0.7 * kRound) * along, kHandle - 0.3 * kRound});
    points.push_back({shank.centre + (kLength + kRound) * along, kHandle - kRound});
}

TriangleMesh explorer(const Detail& detail) {
    const std::vector<TubePoint> hook = {{{0, 0, 0}, 0.08},     {{1.0, 0, -0.55}, 0.17}, {{2.4, 0, -0.5}, 0.25},
                                         {{3.8, 0, 0.7}, 0.33}, {{4.4, 0, 2.8}, 0.42},   {{3.8, 0, 5.2}, 0.52},
                                         {{2.5, 0, 7.8}, 0.65}, {{1.3, 0, 10.8}, 0.80},  {{0.75, 0, 14.5}, 0.95},
                                         {{0.6, 0, 20}, 1.15},  {{0.6, 0, 26}, 1.4}};
    std::vector<TubePoint> points = smoothed(hook, detail.steps);
    if (detail.handle) addHandle(points, Vec3::UnitZ());
    return tube(points, detail.sides);
}

TriangleMesh probe(const Detail& detail) {
    constexpr double kTip = 0.25, kWidening = 0.008;             // mm: radius; growth for each mm
    constexpr double kRing = 0.12, kDepth = 0.04, kEdge = 0.02;  // mm: half width, depth and edge of a mark
    std::vector<TubePoint> points = {{{0, 0, 0}, 0.6 * kTip}, {{0, 0, 0.06}, 0.9 * kTip}, {{0, 0, 0.16}, kTip}};
    for (const double mark : kProbeMarks) {
        if (!detail.handle) break;
        const double radius = kTip + kWidening * mark;
        points.push_back({{0, 0, mark - kRing - kEdge}, radius});
        points.push_back({{0, 0, mark - kRing}, radius - kDepth});
        points.push_back({{0, 0, mark + kRing}, radius - kDepth});
        points.push_back({{0, 0, mark + kRing + kEdge}, radius});
    }
    const std::vector<TubePoint> shank = {{{0, 0, 12}, 0.36},  {{0.25, 0, 14}, 0.45}, {{1.5, 0, 16.6}, 0.6},
                                          {{4.2, 0, 19}, 0.8}, {{8.2, 0, 21.2}, 1.0}, {{13, 0, 23.6}, 1.25},
                                          {{18, 0, 26.1}, 1.4}};
    const std::vector<TubePoint> curve = smoothed(shank, detail.steps);
    points.insert(points.end(), curve.begin(), curve.end());
    if (detail.handle) addHandle(points, Vec3(5, 0, 2.5).normalized());
    return tube(points, detail.sides);
}

// The spoon: a disc of kSpoonRadius around (0, 0, kSpoonRadius), with a rounded back and a hollow in front.
constexpr double kNeck = 0.3;                           // mm, radius
constexpr double kNeckStart = 1.12, kNeckEnd = 1.9;     // mm: over which the spoon becomes the round neck
constexpr double kRoundEnd = 0.05;                      // mm
constexpr double kBack = 0.55, kFront = 0.25;           // of the spoon's radius: its back, its hollow
constexpr double kFirstRing = 0.08, kLastAngle = 0.98;  // of a half turn, from the end of the spoon to its neck

/// Radius of the spoon's rim at a height.
double rimAt(double z) {
    const double aside = kSpoonRadius * kSpoonRadius - (z - kSpoonRadius) * (z - kSpoonRadius);
    return std::max(z > kSpoonRadius ? kNeck : 0.02, std::sqrt(std::max(0.0, aside)));
}

/// Heights of the rings of the spoon, from its end to the neck, mm.
std::vector<double> spoonHeights(int rings) {
    std::vector<double> heights;
    for (int i = 0; i <= rings; ++i) {
        const double part = std::lerp(kFirstRing, kLastAngle, static_cast<double>(i) / rings);
        const double z = kSpoonRadius * (1 - std::cos(std::numbers::pi * part));
        if (z > kNeckStart) break;
        heights.push_back(z);
    }
    return heights;
}

/// Presses the round body of a tube into the spoon: both sides of a ring go to the back, the front one less.
void pressHollow(TriangleMesh& mesh) {
    for (Vec3f& vertex : mesh.vertices) {
        const double y = vertex.y(), z = vertex.z();
        if (z > kNeckEnd) continue;
        const double toEnd = std::clamp(z / kRoundEnd, 0.0, 1.0);  // its flat end stays round
        const double spoon = toEnd * std::clamp((kNeckEnd - z) / (kNeckEnd - kNeckStart), 0.0, 1.0);
        const double pressed = y > 0 ? kBack * y : -kFront * y;
        vertex.y() = static_cast<float>(std::lerp(y, pressed, spoon));
    }
}

TriangleMesh excavator(const Detail& detail) {
    std::vector<TubePoint> points = {{{0, 0, 0}, 0.04}};
    for (const double z : spoonHeights(2 * detail.sides / 3)) points.push_back({{0, 0, z}, rimAt(z)});
    points.push_back({{0, 0, kNeckEnd}, kNeck});
    const std::vector<TubePoint> shank = {{{0, 0, 3.2}, 0.33},   {{0.3, 0, 5.5}, 0.42}, {{1.4, 0, 8.5}, 0.6},
                                          {{3.6, 0, 11.4}, 0.8}, {{7.2, 0, 14}, 1.0},   {{12, 0, 16.6}, 1.25},
                                          {{17, 0, 19.2}, 1.4}};
    const std::vector<TubePoint> curve = smoothed(shank, detail.steps);
    points.insert(points.end(), curve.begin(), curve.end());
    if (detail.handle) addHandle(points, Vec3(5, 0, 2.6).normalized());
    TriangleMesh mesh = tube(points, detail.sides);
    pressHollow(mesh);
    return mesh;
}

/// A hook's tip that lay sideways now points down, and the handle leaves toward +x.
TriangleMesh hookDown(TriangleMesh mesh) {
    constexpr double kLift = 50 * std::numbers::pi / 180;  // rad: steeper, the belly of the hook would touch first
    const Quat turn =
        Quat(Eigen::AngleAxisd(std::numbers::pi, Vec3::UnitZ())) * Quat(Eigen::AngleAxisd(-kLift, Vec3::UnitY()));
    for (Vec3f& vertex : mesh.vertices) vertex = (turn * vertex.cast<double>()).cast<float>();
    return mesh;
}

TriangleMesh made(HandInstrument kind, const Detail& detail) {
    switch (kind) {
        case HandInstrument::Explorer:
            return hookDown(explorer(detail));
        case HandInstrument::Probe:
            return probe(detail);
        case HandInstrument::Excavator:
            return excavator(detail);
    }
    TACTOOTH_ASSERT(false);
    return {};
}

constexpr std::array kInstruments = {
    HandInstrumentSpec{HandInstrument::Explorer, "explorer", &msg::kExplorer, 6, 0.25},
    HandInstrumentSpec{HandInstrument::Probe, "probe", &msg::kPeriodontalProbe, 10, 0.3},
    HandInstrumentSpec{HandInstrument::Excavator, "excavator", &msg::kSpoonExcavator, kNeckEnd, kSpoonRadius}};

}  // namespace

TriangleMesh makeExplorer() { return explorer(kFine); }

TriangleMesh makePeriodontalProbe() { return probe(kFine); }

TriangleMesh makeSpoonExcavator() { return excavator(kFine); }

std::span<const HandInstrumentSpec> handInstruments() { return kInstruments; }

const HandInstrumentSpec& specOf(HandInstrument kind) {
    const auto* const found = std::ranges::find(kInstruments, kind, &HandInstrumentSpec::kind);
    TACTOOTH_ASSERT(found != kInstruments.end());
    return *found;
}

const HandInstrumentSpec* findHandInstrument(std::string_view nameOrTitle) {
    const auto* const found = std::ranges::find_if(kInstruments, [&](const HandInstrumentSpec& spec) {
        return spec.name == nameOrTitle || spec.title->english == nameOrTitle;
    });
    return found == kInstruments.end() ? nullptr : found;
}

TriangleMesh heldInstrument(HandInstrument kind) { return made(kind, kFine); }

TriangleMesh touchingInstrument(HandInstrument kind) { return made(kind, kCoarse); }

std::vector<OutlinePoint> spoonOutline() {
    std::vector<OutlinePoint> outline = {{0, 0}};
    constexpr int kRings = 24;
    for (const double z : spoonHeights(kRings)) outline.push_back({rimAt(z), z});
    outline.push_back({kNeck, kNeckEnd});
    outline.push_back({0, kNeckEnd});
    return outline;
}

}  // namespace tactooth
