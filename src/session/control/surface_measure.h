// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "collision/bvh/surface.h"
#include "geometry/util/ray.h"
#include "tooth/model/layered_tooth.h"

namespace tactooth {

enum class MeasureKind {
    Distance,         ///< straight from place to place
    Angle,            ///< between the normals of the surface at two places
    Taper,            ///< total occlusal convergence of two opposite walls: how far both lean from the axis, together
    RemainingDentin,  ///< straight from a place to the nearest place of the pulp
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

/// The place of the pulp that is nearest to `point`: `point` itself in the pulp. None: the tooth has no pulp.
[[nodiscard]] std::optional<Vec3> nearestPulp(const LayeredTooth& tooth, const Vec3& point);

/// A measurement between two places.
class SurfaceMeasure {
public:
    /// `axis`: unit, out of the tooth; the direction in which a filling or a crown is put in.
    explicit SurfaceMeasure(MeasureKind kind, const Vec3& axis = Vec3::UnitZ()) : kind_(kind), axis_(axis) {}

    [[nodiscard]] MeasureKind kind() const { return kind_; }
    [[nodiscard]] const Vec3& axis() const { return axis_; }
    /// A third place begins a new measurement, and so does each place of RemainingDentin, which goes to `pulp`.
    void add(const MeasuredPlace& place, const std::optional<Vec3>& pulp = {});
    void clear() { places_.clear(); }
    [[nodiscard]] const std::vector<MeasuredPlace>& places() const { return places_; }
    /// Degrees by which each wall of a Taper leans from the axis: positive where it can be seen along the axis,
    /// negative where it is undercut. None until there are two walls that stand opposite each other.
    [[nodiscard]] std::optional<std::array<double, 2>> leans() const;
    /// mm or degrees; none until there are two places. An Angle lies from 0 (walls that face the same way) to 180
    /// (walls that face each other). A Taper is the sum of both leans.
    [[nodiscard]] std::optional<double> result() const;

private:
    MeasureKind kind_;
    Vec3 axis_;
    std::vector<MeasuredPlace> places_;
};

}  // namespace tactooth
