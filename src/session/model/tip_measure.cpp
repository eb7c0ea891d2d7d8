// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/tip_measure.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "collision/bvh/closest_point.h"
#include "session/control/surface_ray.h"

namespace tactooth {
namespace {

constexpr double kFar = 6;         // mm: farther away from the pulp nobody asks
constexpr double kHeadPart = 2.5;  // mm of the head above the tip that can be nearest to the pulp
constexpr double kRings = 0.15;    // mm between two rings of places on the head
constexpr int kAround = 8;         // places around the axis
constexpr double kOutside = 60;    // mm, outside of every tooth
constexpr double kFirstCut = 0.3;  // mm that a bur cuts at once where a force presses it

/// The direction in which the hand presses, into the tooth.
Vec3 inwardOf(const SessionModel& model) {
    if (model.devices().first() == nullptr) return model.manipulator().pressDirection();
    return model.log().newest().contact.proxy.rotation * -Vec3::UnitZ();
}

/// False for an instrument that only touches.
bool canCut(const SessionBur& bur) { return !bur.isHandInstrument() || bur.instrument.scrapes(); }

/// Distance of the head of the bur from one layer.
std::optional<double> distanceOf(const SurfacePart& pulp, const RevolutionEnvelope& head, const Pose& pose) {
    std::optional<double> least;
    double lastZ = -kFar;
    for (const RevolutionEnvelope::ProfilePoint& ring : head.profile()) {
        if (ring.z > head.bottom() + kHeadPart) break;
        if (ring.z < lastZ + kRings) continue;
        lastZ = ring.z;
        const int places = ring.radius > 0 ? kAround : 1;
        for (int i = 0; i < places; ++i) {
            const double angle = 2 * std::numbers::pi * i / places;
            const Vec3 place = pose * Vec3(ring.radius * std::cos(angle), ring.radius * std::sin(angle), ring.z);
            const auto closest = closestPoint(pulp, place, least ? std::abs(*least) : kFar);
            if (!closest) continue;
            const bool isIn = closest->distance < kNearPulp && contains(pulp, place);
            const double distance = isIn ? -closest->distance : closest->distance;
            least = std::min(least.value_or(distance), distance);
        }
    }
    return least;
}

/// How far the tip of `mark` will go along the press direction, mm.
double travelOf(const MouseManipulator& hand, const AimMark& mark) {
    const auto toFloor = hand.depthControl().toFloor(mark.tip, hand.pressDirection());
    if (hand.pressMode() == PressMode::Depth && toFloor) return *toFloor;
    return (*mark.landing - mark.tip).dot(hand.pressDirection()) + kFirstCut;
}

}  // namespace

std::optional<double> probedDepth(const DepthControl& depths, const Pose& probe) {
    const std::optional<double> depth = depths.depthOf(probe.position, probe.rotation * -Vec3::UnitZ());
    return depth && *depth >= 0 ? depth : std::nullopt;
}

TipMeasure tipMeasure(const SessionModel& model) {
    const Tick& newest = model.log().newest();
    TipMeasure measure;
    measure.force = newest.force.wrench.force.norm();
    const DepthControl& depths = model.manipulator().depthControl();
    measure.depth = depths.depthOf(newest.contact.proxy.position, inwardOf(model));
    measure.hold = newest.force.tipHold;
    if (model.bur()->instrument.hand == HandInstrument::Probe) {
        measure.probed = probedDepth(depths, newest.contact.proxy);
    }
    const LayeredTooth& tooth = model.tooth()->piece->tooth();
    for (const LayeredTooth::Layer& layer : tooth.layers()) {
        if (!tooth.materials().hasRole(layer.material, MaterialRole::Pulp)) continue;
        const auto distance = distanceOf(*layer.part, model.bur()->instrument.cutting.envelope, newest.contact.proxy);
        if (distance) measure.overPulp = std::min(measure.overPulp.value_or(*distance), *distance);
    }
    return measure;
}

TipWarning warningOf(const TipMeasure& measure, const SessionModel& model) {
    if (!canCut(*model.bur())) return TipWarning::None;
    if (measure.overPulp && *measure.overPulp < kAtPulp) return TipWarning::AtPulp;
    if (measure.overPulp && *measure.overPulp < kNearPulp) return TipWarning::NearPulp;
    const MouseManipulator& hand = model.manipulator();
    const Tick& newest = model.log().newest();
    const auto left = hand.depthControl().toFloor(newest.contact.proxy.position, inwardOf(model));
    const bool isDeep = hand.pressMode() == PressMode::Depth && left && *left < -kToleratedDepth;
    return isDeep && newest.contact.triangles > 0 ? TipWarning::Deep : TipWarning::None;
}

bool AimMark::touchesBeside() const {
    return std::any_of(ring.begin(), ring.end(), [](const AimPlace& place) { return place.touchesBeside; });
}

AimMark aimMark(const MouseManipulator& hand, double headRadius, const Pose& tool) {
    const MouseManipulator::Surroundings& there = hand.surroundings();
    AimMark mark;
    mark.tip = tool.position;
    const std::optional<Surface>& uncut = hand.depthControl().surface();
    if (there.touchable == nullptr || !uncut) return mark;
    const Vec3& inward = hand.pressDirection();
    // In a cavity: from outside onto the uncut surface. Over the tooth: onto what is there now.
    const auto depth = hand.depthControl().depthOf(mark.tip, inward);
    const bool isInside = depth && *depth > 0;
    // A bur in a fissure has cusps beside it that rise above its tip.
    const double back = isInside ? kOutside : headRadius;
    const Surface& below = isInside ? *uncut : *there.touchable;
    const auto landingOf = [&](const Vec3& place) -> std::optional<Vec3> {
        const Vec3 start = place - back * inward;
        const auto hit = firstHit(below, {start, inward});
        if (!hit) return std::nullopt;
        return start + *hit * inward;
    };
    mark.landing = landingOf(mark.tip);
    if (!mark.landing) return mark;
    const Vec3 u = inward.unitOrthogonal();
    const Vec3 v = inward.cross(u);
    const double travel = travelOf(hand, mark);
    for (int i = 0; i < kRingPlaces; ++i) {
        const double angle = 2 * std::numbers::pi * i / kRingPlaces;
        const Vec3 start = mark.tip + headRadius * (std::cos(angle) * u + std::sin(angle) * v);
        const auto place = landingOf(start);
        if (!place) continue;
        const auto first = firstHitWithNormal(*there.touchable, {start, inward});
        mark.ring.push_back({*place, first && first->isAdjacent && first->distance < travel});
    }
    return mark;
}

}  // namespace tactooth
