// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/neighbours/tool_sides.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

#include "collision/narrow/simd8.h"

// A polytope of fixed directions around a body: J. T. Klosowski et al., "Efficient Collision Detection Using Bounding
// Volume Hierarchies of k-DOPs", IEEE TVCG 4(1), 1998. Differs from the paper: there is one for the whole tool, its
// directions are those of the tool's own faces, and a leaf of the tooth is held against the few that look its way.

namespace tactooth {
namespace {

constexpr int kAround = 5;  // directions along the edge of a cube
// Cosines of 5, 8 and 12 degrees: nearer to another, a direction tells little new. The first that needs no more than
// `kMostSides`: 12 degrees never do.
constexpr double kTooLike[] = {0.9962, 0.9903, 0.9781};
constexpr std::size_t kMostSides = 512;
constexpr std::size_t kMostFaces = 4096;  // the largest of a tool that has more
constexpr float kRoundUp = 1.00001F;      // of a length: what single precision may have lost

/// Inward normals of the triangles, the largest first.
std::vector<Vec3> acrossFaces(const TriangleMesh& mesh) {
    std::vector<Vec3> areas;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Vec3 a = mesh.corner(i, 0);
        const Vec3 area = (mesh.corner(i, 2) - a).cross(mesh.corner(i, 1) - a);
        if (area.squaredNorm() > 0) areas.push_back(area);
    }
    const auto isLarger = [](const Vec3& a, const Vec3& b) { return a.squaredNorm() > b.squaredNorm(); };
    std::ranges::stable_sort(areas, isLarger);
    areas.resize(std::min(areas.size(), kMostFaces));
    for (Vec3& area : areas) area.normalize();
    return areas;
}

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

ToolSides::ToolSides(const TriangleMesh& mesh) {
    keepPoints(mesh);
    if (points_.empty()) return;
    std::vector<Vec3> directions = acrossFaces(mesh);
    std::ranges::copy(allAround(), std::back_inserter(directions));
    std::vector<Vec3> chosen;
    for (const double tooLike : kTooLike) {
        chosen.clear();
        for (const Vec3& direction : directions) {
            const auto isLike = [&](const Vec3& other) { return other.dot(direction) > tooLike; };
            if (chosen.size() <= kMostSides && std::ranges::none_of(chosen, isLike)) chosen.push_back(direction);
        }
        if (chosen.size() <= kMostSides) break;
    }
    for (const Vec3& direction : chosen) sides_.push_back({direction.cast<float>(), 0});
    measure();
    findBeside();
}

/// Each vertex that a triangle uses, once.
void ToolSides::keepPoints(const TriangleMesh& mesh) {
    std::vector<bool> isUsed(mesh.vertices.size());
    for (const Triangle& triangle : mesh.triangles) {
        for (const auto vertex : triangle) isUsed[vertex] = true;
    }
    std::size_t count = 0;
    for (std::size_t i = 0; i < isUsed.size(); ++i) {
        if (!isUsed[i]) continue;
        const Vec3f& point = mesh.vertices[i];
        if (count % 8 == 0) points_.emplace_back();
        for (std::size_t lane = count++ % 8; lane < 8; ++lane) {  // lanes left over repeat the last one
            for (int axis = 0; axis < 3; ++axis) points_.back().at[axis][lane] = point[axis];
            points_.back().far[lane] = kRoundUp * point.norm();
        }
    }
}

float ToolSides::lowAfter(double turn, const Vec3f& inward) const {
    const Vec3x8 d = Vec3x8::all(inward.x(), inward.y(), inward.z());
    const Float8 by = Float8::all(static_cast<float>(turn));
    Float8 low = Float8::all(std::numeric_limits<float>::infinity());
    for (const EightPoints& eight : points_)
        low = min(low, dot(d, Vec3x8::load(eight.at)) - by * Float8::load(eight.far));
    return lowest(low);
}

void ToolSides::measure() {
    for (Side& side : sides_) {
        side.low = lowAfter(0, side.inward);
        // What is lost is convex in the turn: a chord over it is never less.
        for (std::size_t i = 0; i < kTurns.size(); ++i) {
            const auto loss = (side.low - lowAfter(kTurns[i], side.inward)) / static_cast<float>(kTurns[i]);
            losses_[i].push_back(kRoundUp * std::max(loss, 0.0F));
        }
    }
}

ToolSides::Reach ToolSides::across(const Vec3f& inward, float turn) const {
    const float low = lowAfter(0, inward);
    return {{inward, low}, turn > 0 ? kRoundUp * std::max((low - lowAfter(turn, inward)) / turn, 0.0F) : 0};
}

void ToolSides::findBeside() {
    std::vector<Number> order(sides_.size());
    for (const Side& side : sides_) {
        std::iota(order.begin(), order.end(), Number{0});
        const auto isNearer = [&](Number a, Number b) {
            const float nearness = side.inward.dot(sides_[a].inward), other = side.inward.dot(sides_[b].inward);
            return nearness > other || (nearness == other && a < b);
        };
        const auto end = order.begin() + std::min<std::ptrdiff_t>(kBeside, static_cast<std::ptrdiff_t>(order.size()));
        std::partial_sort(order.begin(), end, order.end(), isNearer);
        Beside& beside = beside_.emplace_back();
        beside.fill(order.front());
        std::copy(order.begin(), end, beside.begin());
    }
}

ToolSides::Number ToolSides::facing(const Vec3f& point) const {
    const auto beyond = [&](const Side& side) { return side.low - side.inward.dot(point); };
    std::size_t best = 0;
    float furthest = beyond(sides_[0]);
    for (std::size_t i = 1; i < sides_.size(); ++i) {
        if (const float far = beyond(sides_[i]); far > furthest) furthest = far, best = i;
    }
    return static_cast<Number>(best);
}

std::span<const float> ToolSides::losses(double turn) const {
    std::size_t i = 0;
    while (i + 1 < kTurns.size() && turn > kTurns[i]) ++i;
    return losses_[i];
}

}  // namespace tactooth
