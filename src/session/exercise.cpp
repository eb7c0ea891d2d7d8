// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/exercise.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "collision/closest_point.h"
#include "instruments/bur_catalogue.h"
#include "instruments/bur_shape.h"
#include "session/ideal_shape.h"
#include "session/tooth_source.h"

// Measures of the cavities: an occlusal one 1.5 mm deep at the central fissure with a flat floor, an isthmus of 1.2 mm
// and 2 mm of marginal ridge left (notes on Class II amalgam after Sturdevant's Art and Science of Operative
// Dentistry); one at the neck 1.1 mm deep, its floor along the surface.

namespace tactooth {
namespace {

constexpr double kVoxel = 0.05;    // mm, that of the tooth a student cuts
constexpr double kClear = 20.0;    // mm: outside of every tooth
constexpr double kNear = 1e-4;     // mm, of the surface
constexpr double kStep = 0.1;      // mm between two heights of a floor that follows the surface
constexpr int kMostSteps = 10000;  // of the way to the surface: only a line along it needs as many

const std::vector<Exercise>& allExercises() {
    const Vec3 up = Vec3::UnitZ();
    const Vec3 buccal = Vec3::UnitY();
    static const std::vector<Exercise> all = {
        {"Pit in the molar",
         "Open the central pit 1.5 mm deep, as wide as the bur: down and up again without going aside.",
         BuiltinToothKind::lowerFirstMolar,
         "330",
         {up, 1.5, true, {{{-0.5, -0.1, 0}, {-0.5, -0.1, 0}}}}},
        {"Class I cavity in the molar",
         "Follow the central fissure, 1.5 mm deep and 1.2 mm wide with a flat floor; leave 2 mm of both ridges.",
         BuiltinToothKind::lowerFirstMolar,
         "245",
         {up, 1.5, true, {{{-3, -0.1, 0}, {3, -0.1, 0}}, {{3, -0.3, 0}, {-3, -0.3, 0}}, {{-3, 0.1, 0}, {3, 0.1, 0}}}}},
        {"Class V cavity at the neck of the canine",
         "At the buccal neck, 1.1 mm deep everywhere: the floor follows the surface of the tooth.",
         BuiltinToothKind::upperCanine,
         "330",
         {buccal,
          1.1,
          false,
          {{{-1.2, 0, 1.4}, {1.2, 0, 1.4}}, {{1.2, 0, 1.8}, {-1.2, 0, 1.8}}, {{-1.2, 0, 2.2}, {1.2, 0, 2.2}}}}},
    };
    return all;
}

/// How high the surface stands over `place` along `outward`, by steps that cannot go through it (J. C. Hart, "Sphere
/// tracing", The Visual Computer 12, 1996).
double heightOf(const SurfacePart& outer, const Vec3& place, const Vec3& outward) {
    double height = kClear;
    for (int i = 0; i < kMostSteps && height > -kClear; ++i) {
        const double distance = closestPoint(outer, place + height * outward)->distance;
        if (distance < kNear) break;
        height -= distance;
    }
    return height;
}

std::vector<Vec3> placesOf(const PreparationPlan::Stroke& stroke) {
    const int steps = static_cast<int>(std::ceil((stroke.to - stroke.from).norm() / kStep));
    std::vector<Vec3> places = {stroke.from};
    for (int i = 1; i <= steps; ++i) places.push_back(stroke.from + (stroke.to - stroke.from) * i / steps);
    return places;
}

/// Where the bur's tip goes, stroke after stroke.
std::vector<std::vector<Vec3>> pathsOf(const PreparationPlan& plan, const SurfacePart& outer) {
    std::vector<std::vector<Vec3>> paths;
    double floor = 0;
    for (const PreparationPlan::Stroke& stroke : plan.strokes) {
        std::vector<Vec3> path = placesOf(stroke);
        std::vector<double> heights;
        for (const Vec3& place : path) heights.push_back(heightOf(outer, place, plan.outward));
        if (paths.empty()) {
            for (const double height : heights) floor += height / static_cast<double>(heights.size());
        }
        for (std::size_t i = 0; i < path.size(); ++i) {
            path[i] += ((plan.isFlat ? floor : heights[i]) - plan.depth) * plan.outward;
        }
        paths.push_back(std::move(path));
    }
    return paths;
}

}  // namespace

std::span<const Exercise> exercises() { return allExercises(); }

ToothRequest toothRequest(const Exercise& exercise) {
    constexpr int kTriangles = 20000;
    constexpr double kSound = 0;
    return builtinToothRequest(exercise.tooth, kTriangles, kSound);
}

Expected<TriangleMesh> idealShape(const Exercise& exercise, std::shared_ptr<const LayeredTooth> tooth) {
    const std::optional<BurSpec> bur = findBur(exercise.bur);
    if (!bur) return unexpected(std::string("There is no bur ") + exercise.bur + " in the catalogue.");
    const Expected<CuttingTool> tool = makeCuttingTool(makeBur(*bur).surface);
    if (!tool) return Unexpected{tool.error()};
    const Vec3 outward = exercise.plan.outward;
    const Quat grip = shortestTurn(Vec3::UnitZ(), outward);
    const auto paths = pathsOf(exercise.plan, *tooth->outer());
    WorkPiece piece(std::move(tooth), kVoxel);
    for (const std::vector<Vec3>& path : paths) {
        Pose before{path.front() + kClear * outward, grip};
        for (const Vec3& tip : path) {
            const Pose next{tip, grip};
            piece.sweep(*tool, before, next);
            before = next;
        }
    }
    piece.refreshSurface();
    return asRead(*piece.surface());
}

}  // namespace tactooth
