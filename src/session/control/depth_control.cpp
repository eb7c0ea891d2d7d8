// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/control/depth_control.h"

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/util/assert.h"
#include "session/control/surface_ray.h"

namespace tactooth {
namespace {

constexpr double kBeside = 1e-5;    // mm
constexpr double kInCavity = 0.15;  // mm: a tip deeper than this is in a cavity

}  // namespace

void DepthControl::setSurface(std::shared_ptr<const SurfacePart> uncut) {
    if (uncut_ ? uncut_->base == uncut : uncut == nullptr) return;
    uncut_.reset();
    if (uncut != nullptr) uncut_ = Surface{.base = std::move(uncut)};
    setReference({});
}

void DepthControl::setDepth(double depth) { depth_ = std::clamp(depth, 0.0, kMaxDepth); }

void DepthControl::setFloor(CavityFloor floor) { floor_ = floor; }

void DepthControl::setReference(const std::optional<Vec3>& place) {
    reference_ = place;
    isReferenceSet_ = place.has_value();
}

void DepthControl::beginAt(const Vec3& tip, const Vec3& inward) {
    if (isReferenceSet_) return;
    const std::optional<double> depth = depthOf(tip, inward);
    if (!depth || (reference_ && *depth > kInCavity)) return;
    reference_ = tip - *depth * inward;
}

std::optional<double> DepthControl::depthOf(const Vec3& tip, const Vec3& inward) const {
    TACTOOTH_ASSERT(isUnit(inward));
    if (!uncut_) return std::nullopt;
    // A line right through a corner may pass between the triangles.
    const std::array places = {tip, Vec3(tip + kBeside * inward.unitOrthogonal())};
    for (const Vec3& place : places) {
        if (const double inside = depthInside(*uncut_->base, place, -inward); inside > 0) return inside;
    }
    for (const Vec3& place : places) {
        if (const auto below = firstHit(*uncut_, {place, inward})) return -*below;
    }
    return std::nullopt;
}

std::optional<double> DepthControl::toFloor(const Vec3& tip, const Vec3& inward) const {
    if (floor_ == CavityFloor::Flat && reference_) return depth_ - (tip - *reference_).dot(inward);
    const std::optional<double> depth = depthOf(tip, inward);
    if (!depth) return std::nullopt;
    return depth_ - *depth;
}

}  // namespace tactooth
