// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/neighbours/support_planes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

#include "collision/narrow/round_up.h"
#include "collision/narrow/simd8.h"
#include "geometry/util/pose.h"

// A polytope of fixed directions around a body: J. T. Klosowski et al., "Efficient Collision Detection Using Bounding
// Volume Hierarchies of k-DOPs", IEEE TVCG 4(1), 1998. Differs from the paper: there is one polytope for the whole
// tool, its directions are the normals of the tool's own faces, and a leaf of the tooth is tested against the few
// planes that face it.

namespace tactooth {
namespace {

constexpr int kAround = 5;  // directions along the edge of a cube
// Cosines of 5, 8 and 12 degrees: a direction nearer to another one brings little. The first of them is used that needs
// at most `kMaxPlanes` planes; 12 degrees never need more.
constexpr double kTooSimilar[] = {0.9962, 0.9903, 0.9781};
constexpr std::size_t kMaxPlanes = 512;
constexpr std::size_t kMaxFaces = 4096;  // the largest of a tool that has more

/// Inward normals of the triangles, that of the largest triangle first.
std::vector<Vec3> acrossFaces(const TriangleMesh& mesh) {
    std::vector<Vec3> areas;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Vec3 a = mesh.corner(i, 0);
        const Vec3 area = (mesh.corner(i, 2) - a).cross(mesh.corner(i, 1) - a);
        if (area.squaredNorm() > 0) areas.push_back(area);
    }
    const auto isLarger = [](const Vec3& a, const Vec3& b) { return a.squaredNorm() > b.squaredNorm(); };
    std::ranges::stable_sort(areas, isLarger);
    areas.resize(std::min(areas.size(), kMaxFaces));
    for (Vec3& area : areas) area.normalize();
    return areas;
}

/// Directions evenly all around, from a grid on a cube.
std::vector<Vec3> allAround() {
    std::vector<Vec3> directions;
    for (int axis = 0; axis < 3; ++axis) {
        for (int i = 0; i < 2 * kAround * kAround; ++i) {
            Vec3 direction;
            direction[axis] = i % 2 == 0 ? 1 : -1;
            direction[(axis + 1) % 3] = (i / 2 % kAround + 0.5) * 2 / kAround - 1;
            direction[(axis + 2) % 3] = (i / 2 / kAround + 0.5) * 2 / kAround - 1;
            directions.push_back(direction.normalized());
        }
    }
    return directions;
}

}  // namespace

SupportPlanes::SupportPlanes(const TriangleMesh& mesh) {
    keepPoints(mesh);
    if (points_.empty()) return;
    std::vector<Vec3> directions = acrossFaces(mesh);
    std::ranges::copy(allAround(), std::back_inserter(directions));
    std::vector<Vec3> chosen;
    for (const double tooSimilar : kTooSimilar) {
        chosen.clear();
        for (const Vec3& direction : directions) {
            const auto isSimilar = [&](const Vec3& other) { return other.dot(direction) > tooSimilar; };
            if (chosen.size() <= kMaxPlanes && std::ranges::none_of(chosen, isSimilar)) chosen.push_back(direction);
        }
        if (chosen.size() <= kMaxPlanes) break;
    }
    for (const Vec3& direction : chosen) planes_.push_back({direction.cast<float>(), 0});
    TACTOOTH_ASSERT(!planes_.empty() && planes_.size() <= kMaxPlanes + 1);
    measure();
    findNeighbours();
    TACTOOTH_ASSERT(neighbours_.size() == planes_.size());
}

/// Keeps each vertex that a triangle uses, once.
void SupportPlanes::keepPoints(const TriangleMesh& mesh) {
    std::vector<bool> isUsed(mesh.vertices.size());
    for (const Triangle& triangle : mesh.triangles) {
        for (const auto vertex : triangle) isUsed[vertex] = true;
    }
    std::size_t count = 0;
    for (std::size_t i = 0; i < isUsed.size(); ++i) {
        if (!isUsed[i]) continue;
        const Vec3f& point = mesh.vertices[i];
        if (count % 8 == 0) points_.emplace_back();
        for (std::size_t lane = count++ % 8; lane < 8; ++lane) {  // unused lanes repeat the last one
            for (int axis = 0; axis < 3; ++axis) points_.back().at[axis][lane] = point[axis];
            points_.back().far[lane] = kRoundUp * point.norm();
        }
    }
}

float SupportPlanes::lowAfter(double turn, const Vec3f& inward) const {
    const Vec3x8 d = Vec3x8::all(inward.x(), inward.y(), inward.z());
    const Float8 by = Float8::all(static_cast<float>(turn));
    Float8 low = Float8::all(std::numeric_limits<float>::infinity());
    for (const PointPacket& packet : points_)
        low = min(low, dot(d, Vec3x8::load(packet.at)) - by * Float8::load(packet.far));
    return lowest(low);
}

void SupportPlanes::measure() {
    for (Plane& plane : planes_) {
        plane.low = lowAfter(0, plane.inward);
        // The loss is a convex function of the rotation, so its secant is an upper bound.
        for (std::size_t i = 0; i < kChords.size(); ++i) {
            const auto loss = (plane.low - lowAfter(kChords[i], plane.inward)) / static_cast<float>(kChords[i]);
            losses_[i].push_back(kRoundUp * std::max(loss, 0.0F));
        }
    }
}

SupportPlanes::Reach SupportPlanes::across(const Vec3f& inward, float turn) const {
    TACTOOTH_ASSERT(isUnit(inward));
    TACTOOTH_ASSERT(turn >= 0);
    const float low = lowAfter(0, inward);
    return {{inward, low}, turn > 0 ? kRoundUp * std::max((low - lowAfter(turn, inward)) / turn, 0.0F) : 0};
}

void SupportPlanes::findNeighbours() {
    std::vector<Number> order(planes_.size());
    for (const Plane& plane : planes_) {
        std::iota(order.begin(), order.end(), Number{0});
        const auto isNearer = [&](Number a, Number b) {
            const float nearness = plane.inward.dot(planes_[a].inward), other = plane.inward.dot(planes_[b].inward);
            return nearness > other || (nearness == other && a < b);
        };
        const auto end =
            order.begin() + std::min<std::ptrdiff_t>(kNeighbours, static_cast<std::ptrdiff_t>(order.size()));
        std::partial_sort(order.begin(), end, order.end(), isNearer);
        Neighbours& similar = neighbours_.emplace_back();
        similar.fill(order.front());
        std::copy(order.begin(), end, similar.begin());
    }
}

SupportPlanes::Number SupportPlanes::facing(const Vec3f& point) const {
    TACTOOTH_ASSERT(!planes_.empty());
    const auto beyond = [&](const Plane& plane) { return plane.low - plane.inward.dot(point); };
    std::size_t best = 0;
    float furthest = beyond(planes_[0]);
    for (std::size_t i = 1; i < planes_.size(); ++i) {
        if (const float far = beyond(planes_[i]); far > furthest) furthest = far, best = i;
    }
    return static_cast<Number>(best);
}

std::span<const float> SupportPlanes::losses(double turn) const {
    TACTOOTH_ASSERT(turn >= 0);
    std::size_t i = 0;
    while (i + 1 < kChords.size() && turn > kChords[i]) ++i;
    return losses_[i];
}

}  // namespace tactooth
