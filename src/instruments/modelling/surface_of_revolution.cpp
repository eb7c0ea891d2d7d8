// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/modelling/surface_of_revolution.h"

#include <cmath>
#include <numbers>

#include "geometry/util/assert.h"

namespace tactooth {

TriangleMesh revolved(std::span<const OutlinePoint> outline, int sides) {
    TACTOOTH_ASSERT(outline.size() >= 3 && sides >= 3 && outline.front().radius == 0 && outline.back().radius == 0);
    TriangleMesh body;
    body.vertices.push_back(Vec3(0, 0, outline.front().z).cast<float>());
    const int rings = static_cast<int>(outline.size()) - 2;
    for (int ring = 0; ring < rings; ++ring) {
        const auto [radius, z] = outline[ring + 1];
        for (int side = 0; side < sides; ++side) {
            const double angle = 2 * std::numbers::pi * side / sides;
            body.vertices.push_back(Vec3(radius * std::cos(angle), radius * std::sin(angle), z).cast<float>());
        }
    }
    const auto last = static_cast<std::uint32_t>(body.vertices.size());
    body.vertices.push_back(Vec3(0, 0, outline.back().z).cast<float>());
    const auto at = [&](int ring, int side) { return static_cast<std::uint32_t>(1 + ring * sides + side % sides); };
    for (int side = 0; side < sides; ++side) {
        body.triangles.push_back({0, at(0, side + 1), at(0, side)});
        for (int ring = 0; ring + 1 < rings; ++ring) {
            body.triangles.push_back({at(ring, side), at(ring, side + 1), at(ring + 1, side + 1)});
            body.triangles.push_back({at(ring, side), at(ring + 1, side + 1), at(ring + 1, side)});
        }
        body.triangles.push_back({last, at(rings - 1, side), at(rings - 1, side + 1)});
    }
    return body;
}

}  // namespace tactooth
