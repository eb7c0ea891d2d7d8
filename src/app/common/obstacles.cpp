// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/obstacles.h"

#include <algorithm>

#include "session/control/surface_ray.h"

namespace tactooth {
namespace {

std::vector<Vec3> placesOfWork(const SceneContents& contents) {
    if (contents.tooth == nullptr) return {};
    constexpr double kAlong = 9, kAside = 4;  // mm: to the middle of a neighbour; half of a crown, nearly
    constexpr double kBelow = 6;              // mm: the gum around it
    const Vec3 crown = crownOf(*contents.tooth);
    std::vector<Vec3> places = {crown, crown - kBelow * Vec3::UnitZ()};
    for (const double side : {-1.0, 1.0}) {
        places.push_back(crown + side * kAlong * Vec3::UnitX());
        places.push_back(crown + side * kAside * Vec3::UnitY());
    }
    if (contents.tool) places.push_back(contents.tool->toolInTooth.position);
    if (contents.mirror) places.push_back(contents.mirror->mirrorInTooth * contents.mirror->disc.centre);
    return places;
}

std::optional<Plane> midlineOf(const std::vector<ShownBody>& around) {
    for (const ShownBody& body : around) {
        if (body.beyond && body.beyond->midline) return body.beyond->midline;
    }
    return std::nullopt;
}

}  // namespace

Vec3 crownOf(const Surface& tooth) {
    constexpr double kBelowTop = 3.5;  // mm: half the height of a crown
    const Box3 box = tooth.base->tree().box();
    return {box.center().x(), box.center().y(), box.max().z() - kBelowTop};
}

Obstacles::Obstacles(const SceneContents& contents)
    : eye_(contents.camera.cameraInWorld.position),
      places_(placesOfWork(contents)),
      midline_(midlineOf(contents.around)),
      isBeyondHidden_(
          std::ranges::any_of(contents.around, [this](const ShownBody& body) { return hidesFromBeyond(body); })) {}

std::optional<Obstacles::Obstacle> Obstacles::before(const Vec3& place, const Surface& body) const {
    const double away = (place - eye_).norm();
    if (!(away > 0)) return std::nullopt;
    const Ray sight{eye_, (place - eye_) / away};
    const auto seen = firstSeen(body, sight);
    if (!seen || seen->distance >= away) return std::nullopt;
    return Obstacle{sight.origin + seen->distance * sight.direction, away - seen->distance};
}

bool Obstacles::hidesFromBeyond(const ShownBody& body) const {
    constexpr double kNear = 20;  // mm: what is nearer to the work is no other side, but the next front tooth
    if (!body.beyond) return false;
    const Surface surface{body.beyond->surface};
    return std::ranges::any_of(places_, [&](const Vec3& place) {
        const auto found = before(place, surface);
        if (!found || found->before < kNear) return false;
        return !body.beyond->midline || body.beyond->midline->signedDistance(found->point) < 0;
    });
}

bool Obstacles::hides(const ShownTissue& tissue) const {
    constexpr double kOneSided = 5;  // mm: the middle of a cheek is farther from the midline
    const Vec3 middle = tissue.surface->base->tree().box().center();
    if (isBeyondHidden_ && midline_ && midline_->signedDistance(middle) < -kOneSided) return true;
    return std::ranges::any_of(places_, [&](const Vec3& place) { return before(place, *tissue.surface).has_value(); });
}

}  // namespace tactooth
