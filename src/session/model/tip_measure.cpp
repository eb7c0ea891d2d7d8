// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/tip_measure.h"

#include <algorithm>
#include <cmath>

#include "session/control/surface_ray.h"

namespace tactooth {
namespace {

constexpr double kFar = 6;         // mm: farther away from the pulp nobody asks
constexpr double kOutside = 60;    // mm, outside of every tooth
constexpr double kFirstCut = 0.3;  // mm that a bur cuts at once where a force presses it

/// The direction in which the hand presses, into the tooth.
Vec3 inwardOf(const SessionModel& model) {
    if (model.devices().first() == nullptr) return model.manipulator().pressDirection();
    return model.log().newest().contact.proxy.rotation * -Vec3::UnitZ();
}

/// False for an instrument that only touches.
bool canCut(const SessionBur& bur) { return !bur.isHandInstrument() || bur.instrument.scrapes(); }

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
    measure.overPulp = distanceToPulp(model.tooth()->piece->tooth(), model.bur()->instrument.cutting.envelope,
                                      newest.contact.proxy, kFar);
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

AimMark aimMark(const MouseManipulator& hand, const HeadOutline& head, const Pose& tool) {
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
    const double back = isInside ? kOutside : head.radius();
    const Surface& below = isInside ? *uncut : *there.touchable;
    const auto landingOf = [&](const Vec3& place) -> std::optional<Vec3> {
        const Vec3 start = place - back * inward;
        const auto hit = firstHit(below, {start, inward});
        if (!hit) return std::nullopt;
        return start + *hit * inward;
    };
    mark.landing = landingOf(mark.tip);
    if (!mark.landing) return mark;
    const double travel = travelOf(hand, mark);
    for (const Vec3& aside : head.seenAlong(inward, tool.rotation)) {
        const Vec3 start = mark.tip + aside;
        const auto place = landingOf(start);
        if (!place) continue;
        const auto first = firstHitWithNormal(*there.touchable, {start, inward});
        mark.ring.push_back({*place, first && first->isAdjacent && first->distance < travel});
    }
    return mark;
}

}  // namespace tactooth
