// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/plane_section.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

namespace tactooth {
namespace {

using Edge = std::array<std::uint32_t, 2>;  // lower vertex first

Edge edgeOf(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

/// The part of the edge from a to b within the box, by the parameters of its ends; nothing if it lies outside.
std::optional<std::pair<double, double>> spanWithin(const Vec2& a, const Vec2& b, const Eigen::AlignedBox2d& box) {
    double first = 0, last = 1;
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
        const double along = b[axis] - a[axis];
        if (along == 0) {
            if (a[axis] < box.min()[axis] || a[axis] > box.max()[axis]) return std::nullopt;
            continue;
        }
        const double low = (box.min()[axis] - a[axis]) / along, high = (box.max()[axis] - a[axis]) / along;
        first = std::max(first, std::min(low, high));
        last = std::min(last, std::max(low, high));
    }
    if (first > last) return std::nullopt;
    return std::pair(first, last);
}

}  // namespace

std::vector<SectionLine> planeSection(const TriangleMesh& mesh, const SectionPlane& plane) {
    const Vec3 normal = plane.normal();
    std::vector<double> height;
    height.reserve(mesh.vertices.size());
    for (const Vec3f& vertex : mesh.vertices) height.push_back(normal.dot(vertex.cast<double>() - plane.origin));
    const auto isAbove = [&](std::uint32_t vertex) { return height[vertex] >= 0; };
    std::map<Edge, Vec2> crossings;
    const auto cross = [&](std::uint32_t a, std::uint32_t b) {
        const Edge edge = edgeOf(a, b);
        const Vec3 low = mesh.vertices[edge[0]].cast<double>(), high = mesh.vertices[edge[1]].cast<double>();
        const double share = height[edge[0]] / (height[edge[0]] - height[edge[1]]);
        crossings.emplace(edge, plane.coordinates(low + share * (high - low)));
        return edge;
    };
    std::multimap<Edge, Edge> next;  // from where a triangle is entered to where it is left
    std::map<Edge, int> balance;     // left minus entered
    for (const Triangle& t : mesh.triangles) {
        std::optional<Edge> entered, left;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = t[i], b = t[(i + 1) % 3];
            if (isAbove(a) == isAbove(b)) continue;
            (isAbove(b) ? entered : left) = cross(a, b);
        }
        if (!entered || !left) continue;
        next.emplace(*entered, *left);
        --balance[*entered];
        ++balance[*left];
    }
    std::vector<SectionLine> lines;
    const auto follow = [&](Edge at) {
        SectionLine line;
        const Edge first = at;
        for (auto found = next.find(at); found != next.end(); found = next.find(at)) {
            line.points.push_back(crossings.at(at));
            at = found->second;
            next.erase(found);
        }
        line.closed = at == first;
        if (!line.closed) line.points.push_back(crossings.at(at));
        lines.push_back(std::move(line));
    };
    for (const auto& [edge, count] : balance) {  // open lines from their beginnings
        if (count < 0) follow(edge);
    }
    while (!next.empty()) follow(next.begin()->first);
    return lines;
}

std::vector<Vec2> clipped(const std::vector<Vec2>& line, const Eigen::AlignedBox2d& box) {
    std::vector<Vec2> inside = line;
    for (int side = 0; side < 4; ++side) {
        const Eigen::Index axis = side / 2;
        const double sign = side % 2 == 0 ? 1 : -1;
        const double limit = side % 2 == 0 ? box.min()[axis] : box.max()[axis];
        const std::vector<Vec2> before = std::exchange(inside, {});
        for (std::size_t i = 0; i < before.size(); ++i) {
            const Vec2 &a = before[i], &b = before[(i + 1) % before.size()];
            const double fromA = sign * (a[axis] - limit), fromB = sign * (b[axis] - limit);
            if (fromA >= 0) inside.push_back(a);
            if ((fromA >= 0) != (fromB >= 0)) inside.emplace_back(a + fromA / (fromA - fromB) * (b - a));
        }
    }
    return inside;
}

std::vector<SectionLine> piecesWithin(const SectionLine& line, const Eigen::AlignedBox2d& box) {
    const auto isInside = [&](const Vec2& point) { return box.contains(point); };
    if (std::ranges::all_of(line.points, isInside)) return {line};
    std::vector<SectionLine> pieces;
    const std::size_t count = line.points.size();
    // A closed line begins outside, so that none of its pieces is cut in two.
    const auto outside = std::ranges::find_if_not(line.points, isInside);
    const auto start = line.closed ? static_cast<std::size_t>(outside - line.points.begin()) : 0;
    bool isOpen = false;
    for (std::size_t i = 0; i + (line.closed ? 0 : 1) < count; ++i) {
        const Vec2 &a = line.points[(start + i) % count], &b = line.points[(start + i + 1) % count];
        const auto span = spanWithin(a, b, box);
        if (!span) {
            isOpen = false;
            continue;
        }
        if (!isOpen || span->first > 0) pieces.push_back({{a + span->first * (b - a)}, false});
        pieces.back().points.emplace_back(a + span->second * (b - a));
        isOpen = span->second == 1;
    }
    return pieces;
}

}  // namespace tactooth
