// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "collision/proxy/contact_query.h"
#include "experiments/contact_timing.h"
#include "experiments/experiments.h"
#include "experiments/published.h"
#include "geometry/util/number_text.h"
#include "instruments/ten_patches.h"

namespace tactooth {
namespace {

constexpr std::array kSpeeds = {10.0, 66.0, 100.0, 250.0, 500.0, 1000.0};  // mm/s
constexpr double kShownSpeed = 66;                                         // mm/s, of the curves over time
constexpr double kPerMm = 1e3;                                             // um
constexpr double kReliable = 0.5;  // um: an error below this counts as none, as the published resolution
constexpr int kTouches = 10;       // at each place and speed

/// A place on the object where the hand goes, and from which side.
struct Place {
    const char* name;
    Vec3 at;
    Vec3 outward;  // unit
};

std::vector<Place> placesOf(const TenPatches& piece) {
    const Vec3 onB = (piece.freeSpace[0].normal + piece.freeSpace[1].normal).normalized();
    return {{"A", piece.a, piece.freeSpace[0].normal}, {"B", piece.b, onB}, {"C", piece.c, Vec3::UnitZ()}};
}

/// The hand comes from 1.5 mm above, presses the tip 0.4 mm below the surface, moves 0.5 mm aside, and leaves; one pose
/// a millisecond. `shift` (mm) puts the ticks elsewhere on the same path.
std::vector<Pose> touchAt(const Place& place, double speed, double shift) {
    constexpr double kAbove = 1.5, kBelow = 0.4, kAside = 0.5;  // mm
    const Vec3 aside = kAside * place.outward.unitOrthogonal();
    const std::array<Vec3, 4> corners = {place.at + kAbove * place.outward, place.at - kBelow * place.outward,
                                         place.at - kBelow * place.outward + aside,
                                         place.at + kAbove * place.outward + aside};
    const double step = speed * 1e-3;
    std::vector<Pose> poses = {{corners[0], Quat::Identity()}};
    double into = shift * step;
    for (std::size_t leg = 0; leg + 1 < corners.size(); ++leg) {
        const Vec3 displacement = corners[leg + 1] - corners[leg];
        for (; into < displacement.norm(); into += step) {
            poses.push_back({corners[leg] + into * displacement.normalized(), Quat::Identity()});
        }
        into -= displacement.norm();
    }
    return poses;
}

struct PatchTick {
    double exact, ours;  // depth, mm
    double error;        // between the two answers' places, um
    bool iterationLimitHits;
};

std::vector<PatchTick> follow(const TenPatches& piece, const std::shared_ptr<const Surface>& surface,
                              const std::shared_ptr<const ToolShape>& bur, std::span<const Pose> devicePath) {
    ProxySolver solver(bur);
    solver.setSurface(surface);
    solver.placeAt(devicePath.front());
    std::vector<PatchTick> ticks;
    for (const Pose& pose : devicePath) {
        const MoveResult result = solver.moveToward(pose);
        const Vec3 exact = nearestFreeTip(piece, bur->mesh(), pose);
        const Vec3 ours = solver.pose().position;
        ticks.push_back({(exact - pose.position).norm(), (ours - pose.position).norm(), kPerMm * (ours - exact).norm(),
                         result.status == MoveStatus::OutOfIterations});
    }
    return ticks;
}

std::string reliableText(double reliable) {
    if (reliable == 0) return "none";
    return (reliable == kSpeeds.back() ? "at least " : "") + numberText(reliable / 10) + " cm/s (error below 0.5 um)";
}

ExperimentPlot depthPanel(const Place& place, std::span<const PatchTick> ticks) {
    ExperimentPlot panel{std::string("Depth at ") + place.name + ", " + numberText(kShownSpeed / 10) + " cm/s",
                         "time, ms",
                         "mm",
                         false,
                         false,
                         {}};
    PlotSeries ours{"Tactooth", {}, true, false}, exact{"exact", {}, false, true};
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        ours.points.push_back({static_cast<double>(i), ticks[i].ours});
        exact.points.push_back({static_cast<double>(i), ticks[i].exact});
    }
    panel.series = {ours, exact};
    return panel;
}

}  // namespace

Experiment measureTenPatches(const TestTeeth& testTeeth) {
    const TenPatches piece = makeTenPatches();
    const auto surface = plainSurface(piece.surface);
    Experiment experiment{
        "fig11",
        "Ten-patch object at A, B and C",
        "",
        {"place", "mm_per_s", "ticks", "in_contact", "greatest_depth_mm", "greatest_error_um", "out_of_rounds"},
        {},
        2,
        {},
        {}};
    experiment.method =
        "A concave object of ten flat patches; the bur touches it at A (one patch), B (a valley line, two) and C (a "
        "corner, three), is pressed 0.4 mm in, moved aside and taken away, ten times at each speed with the ticks "
        "elsewhere on the way. The error is the distance between the proxy and the exact answer, which follows from "
        "the "
        "ten planes and the bur's vertices alone.";
    ExperimentPlot errors{"Greatest error of the proxy's place", "speed of the tip, cm/s", "um", true, true, {}};
    double reliable = 0;
    std::array<double, kSpeeds.size()> worst{};
    for (const Place& place : placesOf(piece)) {
        PlotSeries series{place.name, {}, true, false};
        for (std::size_t s = 0; s < kSpeeds.size(); ++s) {
            double error = 0, deepest = 0;
            std::size_t count = 0, touching = 0, iterationLimitHits = 0;
            for (int touch = 0; touch < kTouches; ++touch) {
                const auto devicePath = touchAt(place, kSpeeds[s], static_cast<double>(touch) / kTouches);
                const auto ticks = follow(piece, surface, testTeeth.bur(), devicePath);
                for (const PatchTick& tick : ticks) {
                    error = std::max(error, tick.error);
                    deepest = std::max(deepest, tick.exact);
                    touching += tick.exact > 0 ? 1 : 0;
                    iterationLimitHits += tick.iterationLimitHits ? 1 : 0;
                }
                count += ticks.size();
                if (touch == 0 && kSpeeds[s] == kShownSpeed) experiment.panels.push_back(depthPanel(place, ticks));
            }
            experiment.rows.push_back({std::string(place.name), kSpeeds[s], static_cast<double>(count),
                                       static_cast<double>(touching), deepest, error,
                                       static_cast<double>(iterationLimitHits)});
            constexpr double kMinShown = 1e-6;  // um: a logarithmic axis has no zero
            series.points.push_back({kSpeeds[s] / 10, std::max(error, kMinShown)});
            worst[s] = std::max(worst[s], error);
        }
        errors.series.push_back(series);
    }
    for (std::size_t s = 0; s < kSpeeds.size() && worst[s] <= kReliable; ++s) reliable = kSpeeds[s];
    errors.series.push_back(
        {"0.5 um", {{kSpeeds.front() / 10, kReliable}, {kSpeeds.back() / 10, kReliable}}, false, true});
    experiment.panels.push_back(errors);
    experiment.comparisons = {
        {"Greatest speed of the tip with reliable depth", numberText(published::kReliableOnPatches / 10) + " cm/s",
         reliableText(reliable)},
        {"Greatest error at any speed measured", "not known", shortNumber(*std::ranges::max_element(worst)) + " um"}};
    return experiment;
}

}  // namespace tactooth
