// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "experiments/contact_timing.h"
#include "experiments/experiments.h"
#include "experiments/touch_simulation.h"
#include "geometry/util/number_text.h"

namespace tactooth {
namespace {

constexpr double kPress = 0.5;  // mm beyond the place of first contact

/// Where the bur's tip begins: beside the crown, high up, its shaft upright.
Vec3 nextToCrown(const Box3& tooth, const ToolShape& bur) {
    constexpr double kUp = 0.85, kGap = 0.3;  // share of the height; mm
    return {tooth.center().x(), tooth.min().y() - kGap - bur.radius(), tooth.min().z() + kUp * tooth.sizes().z()};
}

/// How far along +y the bur goes from `start` before the tooth stops it, mm.
double distanceToContact(const std::shared_ptr<const Surface>& surface, const std::shared_ptr<const ToolShape>& bur,
                         const Vec3& start) {
    constexpr double kStep = 0.01;  // mm
    ProxySolver body(bur);
    body.setSurface(surface);
    body.placeAt({start, Quat::Identity()});
    const double farthest = surface->base->tree().box().max().y() - start.y();
    for (double distance = 0; distance < farthest; distance += kStep) {
        if (body.moveToward({start + distance * Vec3::UnitY(), Quat::Identity()}).contactCount > 0) return distance;
    }
    return farthest;
}

/// In along +y until `kPress` beyond the contact, and back.
std::vector<Pose> thereAndBack(const Vec3& start, double contact, double speed) {
    constexpr double kLead = 1;  // mm before the contact
    std::vector<Pose> poses;
    const double step = speed * 1e-3;
    const double turn = kLead + kPress;
    for (double distance = 0; distance < 2 * turn; distance += step) {
        const double y = contact - kLead + (distance < turn ? distance : 2 * turn - distance);
        poses.push_back({start + y * Vec3::UnitY(), Quat::Identity()});
    }
    return poses;
}

}  // namespace

Expected<Experiment> measureSideways(TestTeeth& testTeeth) {
    const auto tooth = testTeeth.tooth(StandardToothKind::Molar);
    if (!tooth) return Unexpected{tooth.error()};
    const auto surface = plainSurface((*tooth)->mesh);
    const auto& bur = testTeeth.bur();
    Experiment experiment{"fig13", "The bur onto a molar along y",
                          "",      {"mm_per_s", "t", "hand_y", "proxy_y", "depth", "fx", "fy", "fz"},
                          {},      2,
                          {},      {}};
    experiment.method =
        "The bur stands upright beside the crown and comes along y until it is pressed 0.5 mm beyond the first "
        "contact, "
        "and goes back. Device and proxy separate where the bur meets the tooth; the force follows the depth.";
    const Vec3 start = nextToCrown(surface->base->tree().box(), *bur);
    const double contact = distanceToContact(surface, bur, start);
    double deepest = 0;
    for (const double speed : {kSlowSpeed, kFastSpeed}) {
        const std::vector<Pose> devicePath = thereAndBack(start, contact, speed);
        const std::vector<Tick> ticks = touchPath(bur, surface, devicePath, 1);
        const std::string at = numberText(speed / 10) + " cm/s";
        ExperimentPlot distance{"Displacement along y, " + at,
                                "time, ms",
                                "mm beyond the contact",
                                false,
                                false,
                                {{"hand", {}, false, true}, {"proxy", {}, false, false}}};
        ExperimentPlot force{"Force, " + at, "time, ms", "N",
                             false,          false,      {{"along y", {}, false, false}, {"across", {}, false, false}}};
        for (const Tick& tick : ticks) {
            const double ms = 1e3 * tick.time;
            const Vec3& f = tick.force.wrench.force;
            distance.series[0].points.push_back({ms, tick.input.device.position.y() - start.y() - contact});
            distance.series[1].points.push_back({ms, tick.contact.proxy.position.y() - start.y() - contact});
            force.series[0].points.push_back({ms, -f.y()});
            force.series[1].points.push_back({ms, std::hypot(f.x(), f.z())});
            deepest = std::max(deepest, tick.contact.depth);
            experiment.rows.push_back({speed, tick.time, tick.input.device.position.y(),
                                       tick.contact.proxy.position.y(), tick.contact.depth, f.x(), f.y(), f.z()});
        }
        experiment.panels.push_back(distance);
        experiment.panels.push_back(force);
    }
    experiment.comparisons = {
        {"Greatest depth when the hand is 0.5 mm beyond the contact", "not known", shortNumber(deepest) + " mm"}};
    return experiment;
}

}  // namespace tactooth
