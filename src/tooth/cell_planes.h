// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/vec.h"

namespace tactooth {

/// The planes in which a border crosses the edges of one cell, and where they put the cell's vertex (the quadric of
/// dual contouring), in single precision. Places count in steps of the lattice from the middle of the cell, so that the
/// vertex is true to a ten-millionth of a step. Equal planes in equal order give equal bits.
class CellPlanes {
public:
    /// What all cells around one edge have in common.
    class Plane {
    public:
        explicit Plane(const Vec3f& n)
            : normal_(n.x(), n.y(), n.z(), 0),
              linear_(n.x(), n.y(), n.z(), n.x() * n.x()),
              products_(Eigen::Array4f(n.x(), n.x(), n.y(), n.y()) * Eigen::Array4f(n.y(), n.z(), n.y(), n.z())) {}

    private:
        friend class CellPlanes;
        Eigen::Array4f normal_;
        Eigen::Array4f linear_;
        Eigen::Array4f products_;
    };

    /// `point`: on the plane, with 1 as its fourth number.
    void add(const Plane& plane, const Eigen::Array4f& point) {
        const Eigen::Array4f along = plane.normal_ * point;
        const float height = along[0] + along[1] + along[2];
        linear_ += plane.linear_;
        products_ += plane.products_;
        ofPoints_ += point;
        offsets_ += height * plane.normal_;
    }

    /// Of the points in which the edges are crossed.
    [[nodiscard]] Vec3f mean() const { return ofPoints_.head<3>().matrix() / ofPoints_[3]; }

    /// If the normals agree so well that the mean one alone counts: the point of the border along it from the mean.
    [[nodiscard]] std::optional<Vec3f> pointOfFlat() const;

    /// The point of `room` nearest to all planes and then to the mean, directions without an edge left out. Where the
    /// planes meet outside, the point slides along the wall of the room: a sharp edge that leaves through it stays
    /// sharp.
    [[nodiscard]] Vec3f nearestPoint(const Box3& room) const;

private:
    [[nodiscard]] Vec3f timesProducts(const Vec3f& vector) const;
    [[nodiscard]] Vec3f offsetsFrom(const Vec3f& point) const {
        return offsets_.head<3>().matrix() - timesProducts(point);
    }

    Eigen::Array4f linear_ = Eigen::Array4f::Zero();    // sums of the normals x, y, z, and of their products xx,
    Eigen::Array4f products_ = Eigen::Array4f::Zero();  // xy, xz, yy, yz
    Eigen::Array4f ofPoints_ = Eigen::Array4f::Zero();  // sum of the points, and how many there are
    Eigen::Array4f offsets_ = Eigen::Array4f::Zero();   // sum of the normals times the points' heights along them
};

}  // namespace tactooth
