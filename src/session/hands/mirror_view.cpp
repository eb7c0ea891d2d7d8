// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/hands/mirror_view.h"

#include "session/control/surface_ray.h"

namespace tactooth {
namespace {

Vec3 reflected(const MirrorDisc& glass, const Vec3& direction) {
    return direction - 2 * direction.dot(glass.normal) * glass.normal;
}

/// The distance along `ray` to the plane of the glass; none where the ray goes away from it.
std::optional<double> meetingWithPlane(const MirrorDisc& glass, const Ray& ray) {
    const double slope = ray.direction.dot(glass.normal);
    if (slope == 0) return std::nullopt;
    const double distance = (glass.centre - ray.origin).dot(glass.normal) / slope;
    return distance >= 0 ? std::optional(distance) : std::nullopt;
}

bool isFree(const Ray& ray, double distance, const Surface& mouth) {
    constexpr double kOnSurface = 0.08;  // mm: a place this near to what is seen is on it
    const auto hit = firstSeen(mouth, ray);
    return !hit || hit->distance + kOnSurface >= distance;
}

}  // namespace

MirrorDisc glassAt(const MirrorDisc& disc, const Pose& mirror) {
    return {mirror * disc.centre, mirror.rotation * disc.normal, disc.radius};
}

Vec3 mirrorImage(const MirrorDisc& glass, const Vec3& place) {
    return glass.centre + reflected(glass, place - glass.centre);
}

std::optional<double> meetingWith(const MirrorDisc& glass, const Ray& ray) {
    const auto distance = meetingWithPlane(glass, ray);
    if (!distance || (ray.origin + *distance * ray.direction - glass.centre).norm() > glass.radius) return std::nullopt;
    return distance;
}

Ray MirrorView::rayThrough(const Vec2& pixel) const {
    const Ray ray = picture_.rayThrough(pixel);
    const auto distance = meetingWithPlane(glass_, ray);
    if (!distance) return {mirrorImage(glass_, ray.origin), reflected(glass_, ray.direction)};
    return {ray.origin + *distance * ray.direction, reflected(glass_, ray.direction)};
}

Mat3 MirrorView::eyeAxes() const {
    const Mat3 reflection = Mat3::Identity() - 2 * glass_.normal * glass_.normal.transpose();
    return reflection * picture_.eyeAxes();
}

bool showsGlass(const PointerView& picture, const Vec2& pixel, const MirrorDisc& glass, const Surface& mouth) {
    const Ray ray = picture.rayThrough(pixel);
    if (ray.direction.dot(glass.normal) >= 0) return false;  // it shows its back
    const auto distance = meetingWith(glass, ray);
    return distance && isFree(ray, *distance, mouth);
}

bool isSeenInMirror(const PointerView& picture, const Vec2& pixel, const MirrorDisc& glass, const Vec3& place,
                    const Surface& mouth) {
    if (!showsGlass(picture, pixel, glass, mouth)) return false;
    const Ray after = MirrorView(picture, glass).rayThrough(pixel);
    return isFree(after, (place - after.origin).dot(after.direction), mouth);
}

}  // namespace tactooth
