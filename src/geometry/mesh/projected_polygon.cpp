// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/projected_polygon.h"

#include <algorithm>

#include "geometry/util/assert.h"
#include "geometry/util/exact_sign.h"

namespace tactooth {

void ProjectedPolygon::set(std::span<const Vec3f> positions, std::span<const std::uint32_t> corners,
                           const Vec3& normal) {
    TACTOOTH_ASSERT(!normal.isZero(0));
    positions_ = positions;
    corners_.assign(corners.begin(), corners.end());
    normal.cwiseAbs().maxCoeff(&axis_);
    isMirrored_ = normal[axis_] < 0;
    points_.clear();
    for (const std::uint32_t corner : corners) {
        TACTOOTH_ASSERT(corner < positions.size());
        const Vec3f& position = positions[corner];
        const double y = position[(axis_ + 2) % 3];
        points_.emplace_back(position[(axis_ + 1) % 3], isMirrored_ ? -y : y);
    }
}

int ProjectedPolygon::exactSide(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const Vec3f& origin = positions_[corners_[a]];
    const int sign = crossProductSign(origin, positions_[corners_[b]], origin, positions_[corners_[c]], axis_);
    return isMirrored_ ? -sign : sign;
}

bool ProjectedPolygon::cross(std::uint32_t a, std::uint32_t c) const {
    const std::uint32_t b = after(a), d = after(c);
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

ProjectedPolygon::Crossing ProjectedPolygon::crossing(std::size_t maxTests) const {
    // Sweep over the edges by their smallest x: each is tested against those that begin before it ends.
    struct Edge {
        double from, to, low, high;
        std::uint32_t corner;
    };
    std::vector<Edge> edges;
    for (std::uint32_t corner = 0; corner < size(); ++corner) {
        const auto [from, to] = std::minmax({x(corner), x(after(corner))});
        const auto [low, high] = std::minmax({y(corner), y(after(corner))});
        edges.push_back({from, to, low, high, corner});
    }
    std::ranges::sort(edges, [](const Edge& a, const Edge& b) {
        return a.from < b.from || (a.from == b.from && a.corner < b.corner);
    });
    std::size_t tests = 0;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        for (std::size_t j = i + 1; j < edges.size() && edges[j].from <= edges[i].to; ++j) {
            if (++tests > maxTests) return Crossing::NotKnown;
            if (edges[j].low > edges[i].high || edges[i].low > edges[j].high) continue;
            if (cross(edges[i].corner, edges[j].corner)) return Crossing::Found;
        }
    }
    return Crossing::None;
}

}  // namespace tactooth
