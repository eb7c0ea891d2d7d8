// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "patient/tooth_sections.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tactooth {
namespace {

/// Adds the contribution of one triangle's cut at height z to Green's integral: half of x dy - y dx along the cut.
void addCut(const std::array<Vec3, 3>& corners, double z, double& area) {
    std::array<Vec3, 2> ends;
    int found = 0;
    bool upwardFirst = false;
    for (int i = 0; i < 3 && found < 2; ++i) {
        const Vec3 &a = corners[i], &b = corners[(i + 1) % 3];
        if ((a.z() < z) == (b.z() < z)) continue;
        if (found == 0) upwardFirst = a.z() < z;
        ends[found++] = a + (z - a.z()) / (b.z() - a.z()) * (b - a);
    }
    if (found < 2) return;
    // Seen from outside the triangle turns left: its cut runs from the side that falls to the side that rises.
    if (upwardFirst) std::swap(ends[0], ends[1]);
    area += 0.5 * (ends[0].x() * ends[1].y() - ends[0].y() * ends[1].x());
}

}  // namespace

SectionProfile sectionProfile(const TriangleMesh& closed, int sections) {
    const Box3 box = boundingBox(closed);
    SectionProfile profile{box.min().z(), box.sizes().z() / sections, std::vector<double>(sections, 0.0)};
    for (std::size_t t = 0; t < closed.triangles.size(); ++t) {
        const std::array<Vec3, 3> corners = {closed.corner(t, 0), closed.corner(t, 1), closed.corner(t, 2)};
        const auto [low, high] = std::minmax({corners[0].z(), corners[1].z(), corners[2].z()});
        const auto sectionAbove = [&](double z) {
            return std::clamp(static_cast<int>(std::ceil((z - profile.bottom) / profile.step - 0.5)), 0, sections);
        };
        for (int i = sectionAbove(low); i < sectionAbove(high); ++i) {
            addCut(corners, profile.bottom + (i + 0.5) * profile.step, profile.areas[i]);
        }
    }
    for (double& area : profile.areas) area = std::abs(area);
    return profile;
}

double neckHeight(const SectionProfile& profile) {
    const auto widest = std::ranges::max_element(profile.areas);
    // Roots end in tips. The bottom section of a crown without roots is nearly as wide as its widest one.
    constexpr double kTip = 0.3, kNearBottom = 0.05;
    const auto nearBottom = static_cast<std::size_t>(kNearBottom * static_cast<double>(profile.areas.size()));
    if (profile.areas[nearBottom] > kTip * *widest) return profile.bottom;
    // The section of the root just below the neck has about 55 to 70 % of the crown's widest section (Wheeler's
    // diameters).
    constexpr double kNeckShare = 0.7;
    auto at = widest - profile.areas.begin();
    while (at > 0 && profile.areas[static_cast<std::size_t>(at)] >= kNeckShare * *widest) --at;
    // Crowns are 30 to 45 % of a tooth (Wheeler): a neck beyond that is a furcation or a bulge.
    constexpr double kLowest = 0.52, kHighest = 0.75;
    const double height = profile.step * static_cast<double>(profile.areas.size());
    return profile.bottom +
           std::clamp((static_cast<double>(at) + 0.5) * profile.step, kLowest * height, kHighest * height);
}

}  // namespace tactooth
