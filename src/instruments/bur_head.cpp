// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/bur_head.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace tactooth {
namespace {

/// The widest place of a bur at one height.
struct Ring {
    double z = 0;
    double radius = 0;
};

/// From the shank down to the tip.
std::vector<Ring> ringsOf(const TriangleMesh& bur) {
    constexpr double kOneRing = 1e-3;  // mm
    std::vector<Ring> points;
    points.reserve(bur.vertices.size());
    for (const auto& v : bur.vertices) {
        points.push_back(
            {static_cast<double>(v.z()), std::hypot(static_cast<double>(v.x()), static_cast<double>(v.y()))});
    }
    std::ranges::sort(points, std::ranges::greater(), &Ring::z);
    std::vector<Ring> rings;
    for (const Ring& point : points) {
        if (rings.empty() || rings.back().z - point.z > kOneRing) {
            rings.push_back(point);
        } else {
            rings.back().radius = std::max(rings.back().radius, point.radius);
        }
    }
    return rings;
}

}  // namespace

BurHead burHeadOf(const TriangleMesh& bur) {
    constexpr double kWider = 1.04;  // times the neck: more than the facets of a round neck differ
    const std::vector<Ring> rings = ringsOf(bur);
    if (rings.empty()) return {};
    // The middle of a closed end of the shank, which has no width.
    auto ring = std::ranges::find_if(rings, [](const Ring& r) { return r.radius > 0; });
    if (ring == rings.end()) return {};
    const double shank = ring->radius;
    double neck = shank;
    double shankStart = rings.back().z;
    for (; ring != rings.end() && ring->radius <= kWider * neck; ++ring) {
        neck = std::min(neck, ring->radius);
        if (ring->radius * kWider >= shank) shankStart = ring->z;
    }
    BurHead head{ring != rings.end() ? ring->z : shankStart, 0, neck};
    for (const Ring& each : rings) {
        if (each.z <= head.length) head.radius = std::max(head.radius, each.radius);
    }
    return head;
}

TriangleMesh headCap(const BurHead& head) {
    constexpr int kCorners = 24;
    TriangleMesh cap;
    if (head.length <= 0 || head.neck <= 0) return cap;
    const auto z = static_cast<float>(head.length);
    cap.vertices.emplace_back(0.F, 0.F, z);
    for (int i = 0; i < kCorners; ++i) {
        const double angle = 2 * std::numbers::pi * i / kCorners;
        cap.vertices.emplace_back(static_cast<float>(head.neck * std::cos(angle)),
                                  static_cast<float>(head.neck * std::sin(angle)), z);
    }
    for (std::uint32_t i = 0; i < kCorners; ++i) cap.triangles.push_back({0, 1 + i, 1 + (i + 1) % kCorners});
    return cap;
}

}  // namespace tactooth
