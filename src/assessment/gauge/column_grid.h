// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// Equal columns along an axis that cover some surfaces. One line runs through each column, at a place that is spread
/// evenly (M. Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018), so that no wall along the
/// grid falls between two rows of lines.
class ColumnGrid {
public:
    /// `axis`: unit. `spacing`: side of a column, mm; larger if the surfaces would need more than a few hundred
    /// thousand.
    ColumnGrid(const Vec3& axis, const TriangleMesh& first, const TriangleMesh& second, double spacing);

    [[nodiscard]] std::size_t size() const { return isCovered_.size(); }
    [[nodiscard]] bool empty() const { return isCovered_.empty(); }
    /// Of the section of one column, mm^2.
    [[nodiscard]] double area() const { return spacing_ * spacing_; }
    /// Whether one of the surfaces lies over or under the column.
    [[nodiscard]] bool isCovered(std::size_t column) const { return isCovered_[column] != 0; }
    /// Covers only those columns whose line `isWanted(place)` accepts, by any place on it.
    template <class Wanted>
    void keep(const Wanted& isWanted) {
        for (std::size_t column = 0; column < size(); ++column) {
            if (isCovered_[column] != 0 && !isWanted(placeOf(column))) isCovered_[column] = 0;
        }
    }
    /// Whether `place` lies in a column that is covered.
    [[nodiscard]] bool covers(const Vec3& place) const;
    /// The place on the line of a column at a height along the axis, mm.
    [[nodiscard]] Vec3 placeAt(std::size_t column, double height) const {
        const Vec3 place = placeOf(column);
        return place + (height - axis_.dot(place)) * axis_;
    }
    /// Whether a ball may lie over or under the grid.
    [[nodiscard]] bool isNear(const Vec3& middle, double radius) const;

    /// Calls `visit(column, height)` for each crossing of a column's line with a triangle; `height` along the axis, mm.
    /// Triangles that share an edge are crossed once there.
    template <class Visit>
    void forEachCrossing(const TriangleMesh& mesh, const Visit& visit) const {
        if (empty()) return;
        for (const Triangle& triangle : mesh.triangles) crossTriangle(mesh, triangle, visit);
    }

private:
    [[nodiscard]] Vec3 local(const Vec3f& place) const {
        const Vec3 from = place.cast<double>();
        return {u_.dot(from) - low_.x(), v_.dot(from) - low_.y(), axis_.dot(from)};
    }
    void cover(const TriangleMesh& mesh);
    /// The columns whose sections a flat box meets: first and last along each side, cut off at the grid.
    struct Range {
        int left, right, bottom, top;
    };
    [[nodiscard]] Range rangeOf(const Vec2& low, const Vec2& high) const;
    [[nodiscard]] Vec2 lineOf(int i, int j) const;
    /// A place on the line of a column.
    [[nodiscard]] Vec3 placeOf(std::size_t column) const;

    /// The side of an edge on which a line runs, the same for both triangles of the edge.
    static bool isLeftOf(const Vec2& line, std::uint32_t from, const Vec3& a, std::uint32_t to, const Vec3& b) {
        const bool turned = from > to;
        const Vec3& p = turned ? b : a;
        const Vec3& q = turned ? a : b;
        const double side = (q.x() - p.x()) * (line.y() - p.y()) - (q.y() - p.y()) * (line.x() - p.x());
        return (side >= 0) != turned;
    }

    template <class Visit>
    void crossTriangle(const TriangleMesh& mesh, const Triangle& t, const Visit& visit) const {
        const std::array<Vec3, 3> p = {local(mesh.vertices[t[0]]), local(mesh.vertices[t[1]]),
                                       local(mesh.vertices[t[2]])};
        const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]);
        if (normal.z() == 0) return;
        const Vec3 low = p[0].cwiseMin(p[1]).cwiseMin(p[2]), high = p[0].cwiseMax(p[1]).cwiseMax(p[2]);
        const Range range = rangeOf(low.head<2>(), high.head<2>());
        for (int j = range.bottom; j <= range.top; ++j) {
            for (int i = range.left; i <= range.right; ++i) {
                const Vec2 line = lineOf(i, j);
                const bool left = isLeftOf(line, t[0], p[0], t[1], p[1]);
                if (isLeftOf(line, t[1], p[1], t[2], p[2]) != left) continue;
                if (isLeftOf(line, t[2], p[2], t[0], p[0]) != left) continue;
                const double along = (normal.x() * (line.x() - p[0].x()) + normal.y() * (line.y() - p[0].y()));
                const double height = std::clamp(p[0].z() - along / normal.z(), low.z(), high.z());
                visit(static_cast<std::size_t>(j) * columns_ + static_cast<std::size_t>(i), height);
            }
        }
    }

    Vec3 axis_, u_, v_;
    Vec2 low_ = Vec2::Zero();  // corner of the grid along u_ and v_, mm
    double spacing_;
    std::size_t columns_ = 0, rows_ = 0;
    std::vector<std::uint8_t> isCovered_;
};

}  // namespace tactooth
