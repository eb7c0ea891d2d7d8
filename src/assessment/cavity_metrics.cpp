// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/cavity_metrics.h"

#include <algorithm>
#include <cmath>

#include "collision/bvh/closest_point.h"
#include "geometry/util/parallel_for.h"

namespace tactooth {
namespace {

constexpr double kSpacing = 0.1;      // mm, between two points
constexpr double kMaxPoints = 4e5;    // in the box around the cavity: a second of work
constexpr std::size_t kGrain = 1024;  // points: about a millisecond

/// A box around the volume that `target` lacks: its walls, and the enamel that stood over them.
Box3 boxOfCavity(const SurfacePart& target, const SurfacePart& outer, const CavityWalls& walls) {
    Box3 box;
    if (walls.mesh.empty()) return box;
    for (const Vec3f& vertex : walls.mesh.vertices) box.extend(vertex.cast<double>());
    const std::vector<Vec3f>& vertices = outer.mesh().vertices;
    std::vector<std::uint8_t> isGone(vertices.size());
    parallelFor(
        vertices.size(),
        [&](std::size_t i) { isGone[i] = signedDistance(target, vertices[i].cast<double>()) > kCavityDepth; }, kGrain);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        if (isGone[i] != 0) box.extend(vertices[i].cast<double>());
    }
    return box;
}

/// One point in each of the equal cubes that fill the box. The points are jittered, so that no flat floor falls between
/// two layers of points: the additive recurrence of M. Roberts, "The unreasonable effectiveness of quasirandom
/// sequences", 2018.
std::vector<Vec3f> pointsIn(const Box3& box, double spacing) {
    constexpr double kPlastic = 1.2207440846057596;  // root of x^4 = x + 1
    const Vec3 step(1 / kPlastic, 1 / (kPlastic * kPlastic), 1 / (kPlastic * kPlastic * kPlastic));
    Vec3 place = Vec3::Constant(0.5);  // in the cube, of its side
    std::vector<Vec3f> points;
    const Eigen::Array3i counts = (box.sizes().array() / spacing).ceil().cast<int>();
    for (int z = 0; z < counts.z(); ++z) {
        for (int y = 0; y < counts.y(); ++y) {
            for (int x = 0; x < counts.x(); ++x) {
                place += step;
                place -= place.array().floor().matrix();
                points.push_back((box.min() + spacing * (Vec3(x, y, z) + place)).cast<float>());
            }
        }
    }
    return points;
}

}  // namespace

CavityMetrics::CavityMetrics(std::shared_ptr<const SurfacePart> target, const SurfacePart& outer)
    : CavityMetrics(target, outer, cavityWalls(target->mesh(), outer)) {}

CavityMetrics::CavityMetrics(std::shared_ptr<const SurfacePart> target, const SurfacePart& outer,
                             const CavityWalls& walls)
    : target_(std::move(target)) {
    const Box3 box = boxOfCavity(*target_, outer, walls);
    if (box.isEmpty()) return;
    const double spacing = std::max(kSpacing, std::cbrt(box.volume() / kMaxPoints));
    pointVolume_ = spacing * spacing * spacing;
    const std::vector<Vec3f> all = pointsIn(box, spacing);
    std::vector<std::uint8_t> isIn(all.size());
    parallelFor(
        all.size(),
        [&](std::size_t i) {
            const Vec3 point = all[i].cast<double>();
            const double above = signedDistance(*target_, point);
            if (above <= 0) return;
            const double below = -signedDistance(outer, point);
            isIn[i] = below > 0 && above + below > kCavityDepth;
        },
        kGrain);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (isIn[i] != 0) points_.push_back(all[i]);
    }
    isCleared_.resize(points_.size());
}

void CavityMetrics::takeCleared(const Surface& tooth) {
    const Box3 changed = change_.changedBox(tooth);
    if (changed.isEmpty()) return;
    parallelFor(
        points_.size(),
        [&](std::size_t i) {
            const Vec3 point = points_[i].cast<double>();
            if (changed.contains(point)) isCleared_[i] = !contains(tooth, point);
        },
        kGrain);
    cleared_ = static_cast<std::size_t>(std::count(isCleared_.begin(), isCleared_.end(), 1));
}

/// Measures only the new patches.
double CavityMetrics::maxOverPreparationOf(const Surface& tooth) {
    std::unordered_map<std::uint64_t, double> now;
    std::vector<const SurfacePart*> fresh;
    for (const auto& patch : tooth.patches) {
        const auto known = overPreparation_.find(patch->id());
        if (known != overPreparation_.end())
            now.insert(*known);
        else
            fresh.push_back(patch.get());
    }
    std::vector<double> depths(fresh.size());
    parallelFor(fresh.size(), [&](std::size_t i) {
        for (const Vec3f& vertex : fresh[i]->mesh().vertices) {
            depths[i] = std::max(depths[i], -signedDistance(*target_, vertex.cast<double>()));
        }
    });
    for (std::size_t i = 0; i < fresh.size(); ++i) now.emplace(fresh[i]->id(), depths[i]);
    overPreparation_ = std::move(now);
    double maxOverPreparation = 0;
    for (const auto& [id, depth] : overPreparation_) maxOverPreparation = std::max(maxOverPreparation, depth);
    return maxOverPreparation;
}

CavityProgress CavityMetrics::of(const Surface& tooth, double removed) {
    takeCleared(tooth);
    const double cleared = pointVolume_ * static_cast<double>(cleared_);
    return {.planned = pointVolume_ * static_cast<double>(points_.size()),
            .cleared = cleared,
            .beyond = std::max(0.0, removed - cleared),
            .maxOverPreparation = maxOverPreparationOf(tooth)};
}

}  // namespace tactooth
