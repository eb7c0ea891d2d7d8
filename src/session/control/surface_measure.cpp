// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/control/surface_measure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "collision/bvh/closest_point.h"
#include "geometry/util/assert.h"
#include "geometry/util/degree.h"
#include "geometry/util/pose.h"
#include "session/control/surface_ray.h"

namespace tactooth {
namespace {

constexpr int kRays = 512;            // through the disc: the mean of a step between two planes is true to 0.3 degrees
constexpr double kLeastFacing = 0.1;  // cosine: the rays hardly meet what is steeper
constexpr int kRounds = 2;            // the second one looks along the mean normal of the first
constexpr double kFloor = 60;         // degrees: what leans more from the axis is no wall
constexpr double kOpposite = 135;     // degrees between walls, seen along the axis: those of a rounded box are 180

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

std::optional<Vec3> nearestPulp(const LayeredTooth& tooth, const Vec3& point) {
    std::optional<Vec3> nearest;
    for (const LayeredTooth::Layer& layer : tooth.layers()) {
        if (!tooth.materials().hasRole(layer.material, MaterialRole::Pulp)) continue;
        if (contains(*layer.part, point)) return point;
        const double least = nearest ? (*nearest - point).norm() : std::numeric_limits<double>::max();
        if (const auto closest = closestPoint(*layer.part, point, least)) nearest = closest->point;
    }
    return nearest;
}

void SurfaceMeasure::add(const MeasuredPlace& place, const std::optional<Vec3>& pulp) {
    if (places_.size() == 2 || kind_ == MeasureKind::RemainingDentin) places_.clear();
    places_.push_back(place);
    if (kind_ == MeasureKind::RemainingDentin && pulp) places_.push_back({*pulp, -place.normal});
}

std::optional<std::array<double, 2>> SurfaceMeasure::leans() const {
    if (kind_ != MeasureKind::Taper || places_.size() < 2) return std::nullopt;
    std::array<double, 2> leans{};
    std::array<Vec3, 2> across;  // the walls' directions, seen along the axis
    for (std::size_t i = 0; i < 2; ++i) {
        const Vec3& normal = places_[i].normal;
        leans[i] = std::asin(std::clamp(normal.dot(axis_), -1.0, 1.0)) / kDegree;
        if (std::abs(leans[i]) > kFloor) return std::nullopt;
        across[i] = (normal - normal.dot(axis_) * axis_).normalized();
    }
    if (across[0].dot(across[1]) > std::cos(kOpposite * kDegree)) return std::nullopt;
    return leans;
}

std::optional<double> SurfaceMeasure::result() const {
    if (places_.size() < 2) return std::nullopt;
    if (kind_ == MeasureKind::Taper) {
        const auto both = leans();
        return both ? std::optional((*both)[0] + (*both)[1]) : std::nullopt;
    }
    const MeasuredPlace &first = places_[0], &second = places_[1];
    if (kind_ != MeasureKind::Angle) return (second.point - first.point).norm();
    // From both products: near 0 and 180 degrees the cosine alone loses half of the digits.
    const double sine = first.normal.cross(second.normal).norm(), cosine = first.normal.dot(second.normal);
    return std::atan2(sine, cosine) / kDegree;
}

}  // namespace tactooth
