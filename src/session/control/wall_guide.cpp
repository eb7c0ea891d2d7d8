// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/control/wall_guide.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

constexpr int kAround = 12;      // points on a ring: their chords are 3 % of the radius inside the circle at most
constexpr double kAlong = 0.25;  // mm between two rings
constexpr std::size_t kMostRings = 24;  // 288 points: some microseconds a tick
constexpr double kSpacing = 0.12;       // mm of the grid
constexpr double kMargin = 1.5;         // mm around the cavity: as far as a hand goes astray while it works in it
constexpr int kMostSamples = 128;       // along the longest side

/// Rings on the outline of the bur, `kAlong` apart.
std::vector<Vec3> pointsOn(const RevolutionEnvelope& bur) {
    std::vector<RevolutionProfilePoint> rings;
    const std::vector<RevolutionProfilePoint>& profile = bur.profile();
    double length = 0;
    for (std::size_t i = 1; i < profile.size(); ++i)
        length += std::hypot(profile[i].radius - profile[i - 1].radius, profile[i].z - profile[i - 1].z);
    const double step = std::max(kAlong, length / static_cast<double>(kMostRings));
    double next = 0, passed = 0;
    for (std::size_t i = 1; i < profile.size(); ++i) {
        const double dr = profile[i].radius - profile[i - 1].radius, dz = profile[i].z - profile[i - 1].z;
        const double piece = std::hypot(dr, dz);
        for (; piece > 0 && next <= passed + piece; next += step) {
            const double share = (next - passed) / piece;
            rings.push_back({profile[i - 1].radius + share * dr, profile[i - 1].z + share * dz});
        }
        passed += piece;
    }
    std::vector<Vec3> points;
    for (const auto& [r, z] : rings) {
        const int count = r > 0 ? kAround : 1;
        for (int i = 0; i < count; ++i) {
            const double angle = 2 * std::numbers::pi * i / count;
            points.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
        }
    }
    return points;
}

}  // namespace

WallGuide::WallGuide(std::shared_ptr<const DistanceGrid> walls, const RevolutionEnvelope& bur)
    : walls_(std::move(walls)), points_(pointsOn(bur)) {
    TACTOOTH_ASSERT(walls_ != nullptr && !points_.empty());
}

FixtureForce WallGuide::push(const Pose& tool) const {
    GridSample deepest{0, Vec3::Zero()};
    for (const Vec3& point : points_) {
        const auto sample = walls_->at(tool * point);
        if (sample && sample->distance < deepest.distance) deepest = *sample;
    }
    const double slope = deepest.gradient.norm();
    if (!(slope > 0)) return {};
    const double beyond = -deepest.distance;
    constexpr double kBends = kMostForce / kStiffness;  // mm: from there on the force is constant
    const double pressed = std::min(beyond, kBends);
    return {.force = kStiffness * pressed / slope * deepest.gradient,
            .beyond = beyond,
            .energy = kStiffness * pressed * (beyond - pressed / 2)};
}

DistanceGrid guideWalls(const SurfacePart& ideal, const Box3& cavity) {
    const Box3 box(cavity.min() - Vec3::Constant(kMargin), cavity.max() + Vec3::Constant(kMargin));
    const double longest = box.sizes().maxCoeff();
    return sampleDistances(ideal, box, std::min(kMostSamples, static_cast<int>(std::ceil(longest / kSpacing)) + 1));
}

}  // namespace tactooth
