// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/surface_line.h"

#include <algorithm>
#include <cmath>

#include "session/control/surface_ray.h"

namespace tactooth {
namespace {

constexpr double kStep = 0.2;      // mm between two places: no step is seen
constexpr double kLift = 0.02;     // mm above the surface
constexpr double kNotThere = 3.0;  // mm from the straight line: that is another side of the tooth

}  // namespace

std::vector<Vec3> lineOnSurface(const std::vector<Vec3>& points, const Vec3& outward, bool isClosed,
                                const std::shared_ptr<const SurfacePart>& surface) {
    std::vector<Vec3> line;
    const Surface whole{.base = surface};
    const auto add = [&](const Vec3& straight) {
        const auto hit = firstHit(whole, {straight + kFarAway * outward, -outward});
        const double above = hit ? kFarAway - *hit : 0;
        line.emplace_back(straight + ((std::abs(above) < kNotThere ? above : 0) + kLift) * outward);
    };
    const std::size_t edges = points.size() - (isClosed || points.empty() ? 0 : 1);
    for (std::size_t i = 0; i < edges; ++i) {
        const Vec3 &a = points[i], &b = points[(i + 1) % points.size()];
        const int steps = std::max(1, static_cast<int>(std::ceil((b - a).norm() / kStep)));
        for (int k = i == 0 ? 0 : 1; k <= steps; ++k) add(a + (b - a) * k / steps);
    }
    return line;
}

}  // namespace tactooth
