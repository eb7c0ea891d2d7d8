// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "geometry/util/vec.h"

namespace tactooth {

/// A closed line on the surface of a tooth, seen along a direction: a polygon in the plane square to it, mm.
class FlatOutline {
public:
    using Point = Vec2;

    /// `corners`: tooth frame, mm, the first not repeated; `outward`: unit, toward the eye.
    FlatOutline(std::span<const Vec3> corners, const Vec3& outward);

    [[nodiscard]] const std::vector<Point>& corners() const { return corners_; }
    [[nodiscard]] const Vec3& outward() const { return outward_; }
    /// A place of the tooth as it is seen, and the place of the tooth that is seen there at a height along `outward`.
    [[nodiscard]] Point flat(const Vec3& place) const { return {u_.dot(place), v_.dot(place)}; }
    [[nodiscard]] Vec3 placeAt(const Point& point, double height) const {
        return point.x() * u_ + point.y() * v_ + height * outward_;
    }
    [[nodiscard]] bool contains(const Point& point) const;
    /// To the line, mm.
    [[nodiscard]] double distance(const Point& point) const;
    /// Whether the line meets itself; also where it has fewer than three corners.
    [[nodiscard]] bool crossesItself() const;
    /// Whether a bur of this radius has room inside, somewhere.
    [[nodiscard]] bool hasRoomFor(double radius) const;
    /// mm^2, positive where the corners run counter-clockwise for the eye.
    [[nodiscard]] double signedArea() const;
    [[nodiscard]] const Eigen::AlignedBox2d& box() const { return box_; }
    /// The edge into which a new corner fits best: it becomes the corner after this one. There are at least two.
    [[nodiscard]] std::size_t edgeFor(const Point& point) const;

private:
    [[nodiscard]] const Point& next(std::size_t corner) const { return corners_[(corner + 1) % corners_.size()]; }

    Vec3 outward_, u_, v_;
    std::vector<Point> corners_;
    Eigen::AlignedBox2d box_;
};

}  // namespace tactooth
