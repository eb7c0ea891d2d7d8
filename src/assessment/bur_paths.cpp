// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "assessment/body_paths.h"
#include "assessment/exercise.h"
#include "assessment/outline/fissure_path.h"
#include "assessment/outline/outline_paths.h"

namespace tactooth {
namespace {

constexpr double kPathStep = 0.1;  // mm between two places: a floor that follows the surface is as fine
constexpr double kRow = 0.2;       // mm between two passes of a bur

std::vector<Vec3> placesOf(const Vec3& from, const Vec3& to) {
    const int steps = static_cast<int>(std::ceil((to - from).norm() / kPathStep));
    std::vector<Vec3> places = {from};
    for (int i = 1; i <= steps; ++i) places.push_back(from + (to - from) * i / steps);
    return places;
}

std::vector<BurPath> alongFissure(const PreparationPlan& plan, std::shared_ptr<const SurfacePart> outer) {
    const CrownView crown(std::move(outer));
    const FissureOutline& outline = *plan.fissure;
    const auto [middle, boxesAt] = fissureMiddle(plan, crown);
    if (middle.empty()) return {};
    // The bur enters in the middle, where the passes beside remove the wider hole of its entry.
    BurPath along{{middle.begin() + static_cast<std::ptrdiff_t>(middle.size() / 2), middle.end()}, plan.depth};
    along.places.insert(along.places.end(), middle.rbegin(), middle.rend());
    std::vector<BurPath> paths = {along};
    const double aside = outline.width / 2 - outline.burRadius;
    const int rows = static_cast<int>(std::ceil(aside / kRow));
    for (int row = 1; row <= rows; ++row) {
        for (const double sign : {1.0, -1.0}) {
            BurPath path{middle, plan.depth};
            for (Vec3& place : path.places) place.y() += sign * aside * row / rows;
            if (sign < 0) std::ranges::reverse(path.places);
            paths.push_back(std::move(path));
        }
    }
    double sum = 0;
    for (const Vec3& place : middle) sum += crown.heightAt(place.x(), place.y());
    const double floor = sum / static_cast<double>(middle.size()) - plan.depth;
    for (std::size_t i = 0; i < plan.boxes.size(); ++i) {
        std::ranges::move(throughBox(plan.boxes[i], outline.burRadius, plan.depth, crown, boxesAt[i], floor),
                          std::back_inserter(paths));
    }
    return paths;
}

}  // namespace

std::vector<BurPath> burPaths(const PreparationPlan& plan, const LayeredTooth& tooth,
                              const std::shared_ptr<const SurfacePart>& outer) {
    if (plan.crown) return {};
    if (plan.fissure) return alongFissure(plan, outer);
    if (plan.outline) return throughOutline(plan, outer);
    if (plan.body) return throughBody(plan, tooth, *outer);
    std::vector<BurPath> paths;
    for (const PreparationPlan::Stroke& stroke : plan.strokes)
        paths.push_back({placesOf(stroke.from, stroke.to), stroke.depth.value_or(plan.depth)});
    return paths;
}

}  // namespace tactooth
