// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/control/surface_measure.h"

#include <cmath>
#include <numbers>

#include "geometry/util/assert.h"
#include "geometry/util/pose.h"
#include "session/control/surface_ray.h"

namespace tactooth {
namespace {

constexpr int kRays = 512;            // through the disc: the mean of a step between two planes is true to 0.3 degrees
constexpr double kLeastFacing = 0.1;  // cosine: the rays hardly meet what is steeper
constexpr int kRounds = 2;            // the second one looks along the mean normal of the first

/// The sum of area times normal, as rays along -`axis` meet the surface.
Vec3 areaSum(const Surface& surface, const Vec3& point, const Vec3& axis, double radius) {
    const Vec3 u = axis.unitOrthogonal(), v = axis.cross(u);
    // Sunflower: each ray stands for the same area of the disc (H. Vogel, "A better way to construct the sunflower
    // head", Math. Biosci. 44, 1979).
    const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < kRays; ++i) {
        const double r = radius * std::sqrt((i + 0.5) / kRays), angle = golden * i;
        const Vec3 origin = point + radius * axis + r * (std::cos(angle) * u + std::sin(angle) * v);
        const auto hit = firstHitWithNormal(surface, Ray{origin, -axis});
        if (!hit) continue;
        const double cosine = hit->normal.dot(axis);
        const Vec3 place = origin - hit->distance * axis;
        if (cosine < kLeastFacing || (place - point).norm() > radius) continue;
        sum += hit->normal / cosine;  // a steep piece has more area than the ray's share of the disc
    }
    return sum;
}

}  // namespace

Vec3 meanNormal(const Surface& surface, const Vec3& point, const Vec3& facing, double radius) {
    TACTOOTH_ASSERT(radius > 0);
    TACTOOTH_ASSERT(isUnit(facing));
    Vec3 axis = facing;
    for (int round = 0; round < kRounds; ++round) {
        const Vec3 sum = areaSum(surface, point, axis, radius);
        if (sum.isZero(0)) return axis;  // a spike thinner than the rays
        axis = sum.normalized();
    }
    return axis;
}

std::optional<MeasuredPlace> placeOn(const Surface& surface, const Ray& seen) {
    constexpr double kBeside = 1e-5;  // mm: a ray right through an edge may pass between the triangles
    Ray ray = seen;
    auto hit = firstSeen(surface, ray);
    if (!hit) {
        const Vec3 u = ray.direction.unitOrthogonal();
        ray.origin += kBeside * (0.8 * u + 0.6 * ray.direction.cross(u));  // not along the edge of a grid either
        hit = firstSeen(surface, ray);
    }
    if (!hit) return std::nullopt;
    const Vec3 point = ray.origin + hit->distance * ray.direction;
    const Vec3 towardEye = hit->normal.dot(ray.direction) > 0 ? Vec3(-hit->normal) : hit->normal;  // an open surface
    if (towardEye.isZero(0)) return std::nullopt;
    return MeasuredPlace{point, meanNormal(surface, point, towardEye, kNormalDisc)};
}

void SurfaceMeasure::add(const MeasuredPlace& place) {
    if (places_.size() == 2) places_.clear();
    places_.push_back(place);
}

std::optional<double> SurfaceMeasure::result() const {
    if (places_.size() < 2) return std::nullopt;
    const MeasuredPlace &first = places_[0], &second = places_[1];
    if (kind_ == MeasureKind::Distance) return (second.point - first.point).norm();
    // From both products: near 0 and 180 degrees the cosine alone loses half of the digits.
    const double sine = first.normal.cross(second.normal).norm(), cosine = first.normal.dot(second.normal);
    return std::atan2(sine, cosine) * 180 / std::numbers::pi;
}

}  // namespace tactooth
