// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "collision/bvh/surface.h"
#include "geometry/util/ray.h"

namespace tactooth {

enum class MeasureKind {
    Distance,  ///< straight from place to place
    Angle,     ///< between the normals of the surface at two places
};

/// A place on a surface, in its frame.
struct MeasuredPlace {
    Vec3 point;   ///< mm
    Vec3 normal;  ///< unit, outward, averaged over the disc around the point
};

/// Radius of the disc over which a normal is averaged, mm: several times the triangles of a tooth, and less than the
/// height of a wall.
inline constexpr double kNormalDisc = 0.3;

/// The mean of the normals of `surface` within `radius` of `point`, weighted by area: of that side of the surface which
/// faces as `facing` does (unit, the normal at the point). Unit, outward.
[[nodiscard]] Vec3 meanNormal(const Surface& surface, const Vec3& point, const Vec3& facing, double radius);

/// The first place that `ray` meets; none if it meets no triangle.
[[nodiscard]] std::optional<MeasuredPlace> placeOn(const Surface& surface, const Ray& ray);

/// A measurement between two places.
class SurfaceMeasure {
public:
    explicit SurfaceMeasure(MeasureKind kind) : kind_(kind) {}

    [[nodiscard]] MeasureKind kind() const { return kind_; }
    /// A third place begins a new measurement.
    void add(const MeasuredPlace& place);
    void clear() { places_.clear(); }
    [[nodiscard]] const std::vector<MeasuredPlace>& places() const { return places_; }
    /// mm or degrees (0 to 180); none until there are two places. Walls that face the same way have an angle of 0,
    /// those that face each other one of 180.
    [[nodiscard]] std::optional<double> result() const;

private:
    MeasureKind kind_;
    std::vector<MeasuredPlace> places_;
};

}  // namespace tactooth
