// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/outline/outline_templates.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "assessment/outline/fissure_path.h"
#include "session/control/surface_ray.h"

namespace tactooth {
namespace {

constexpr double kCorner = 1.2;     // mm between two corners along the fissure: few enough to be moved by hand
constexpr double kHalfNeck = 0.25;  // of the crown's width: half of the length of an outline at the neck
constexpr double kLower = 0.9, kUpper = 2.9;           // mm over the cervical line, in the middle of the outline
constexpr double kLowerBend = 0.35, kUpperBend = 0.1;  // mm by which it rises toward its ends, as the gum does

}  // namespace

std::vector<Vec3> fissureOutlineOn(const PreparationPlan& plan, const std::shared_ptr<const SurfacePart>& outer) {
    const CrownView crown(outer);
    const std::vector<Vec3> path = fissureMiddle(plan, crown).path;
    if (path.empty()) return {};
    const double length = path.back().x() - path.front().x();
    const int parts = std::max(1, static_cast<int>(std::round(length / kCorner)));
    std::vector<Vec3> middle;
    for (int i = 0; i <= parts; ++i)
        middle.push_back(path[(path.size() - 1) * static_cast<std::size_t>(i) / static_cast<std::size_t>(parts)]);
    middle.front().x() -= plan.fissure->burRadius;
    middle.back().x() += plan.fissure->burRadius;
    std::vector<Vec3> corners;
    const auto add = [&](const Vec3& place, double aside) {
        const double y = place.y() + aside;
        corners.emplace_back(place.x(), y, crown.heightAt(place.x(), y));
    };
    const double half = plan.fissure->width / 2;
    for (const Vec3& place : middle) add(place, -half);
    std::ranges::reverse(middle);
    for (const Vec3& place : middle) add(place, half);
    return corners;
}

std::vector<Vec3> neckOutlineOn(const std::shared_ptr<const SurfacePart>& outer, double towardY) {
    const Surface surface{.base = outer};
    const double half = kHalfNeck * CrownView(outer).box().sizes().x();
    std::vector<Vec3> corners;
    const auto add = [&](double part, double z) {
        const Vec3 far(part * half, towardY * kFarAway, z);
        const auto hit = firstHit(surface, {far, -towardY * Vec3::UnitY()});
        if (hit) corners.emplace_back(far - *hit * towardY * Vec3::UnitY());
    };
    constexpr std::array kParts = {-1.0, -0.5, 0.0, 0.5, 1.0};
    for (const double part : kParts) add(part, kLower + kLowerBend * part * part);
    for (const double part : kParts) add(-part, kUpper + kUpperBend * part * part);
    return corners;
}

}  // namespace tactooth
