// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cassert>

#include "session/experiments/contact_timing.h"
#include "session/experiments/experiments.h"
#include "session/experiments/published.h"
#include "session/experiments/touching_hand.h"

namespace tactooth {
namespace {

constexpr int kRepeat = 5;

struct Figure {
    const char* id;
    published::ForceTime published;
};

Figure figureOf(StandardToothKind kind) {
    switch (kind) {
        case StandardToothKind::Front:
            return {"fig15", published::kFrontTooth};
        case StandardToothKind::Dog:
            return {"fig16", published::kDogTooth};
        case StandardToothKind::Molar:
            return {"fig17", published::kMolar};
        case StandardToothKind::Large:
            break;
    }
    assert(false);
    return {};
}

/// One curve over time.
PlotPanel panelOf(const std::string& title, const std::string& unit, std::span<const Tick> ticks,
                  double (*value)(const Tick&)) {
    PlotPanel panel{title, "time, ms", unit, false, false, {{"", {}, false, false}}};
    for (const Tick& tick : ticks) panel.series[0].points.push_back({1e3 * tick.time, value(tick)});
    return panel;
}

struct Run {
    double speed;  // mm/s
    std::vector<Tick> ticks;
};

void addRows(Experiment& experiment, const Run& run) {
    for (const Tick& tick : run.ticks) {
        experiment.rows.push_back({run.speed, tick.time, tick.depth, tick.speed, tick.wrench.force.norm(),
                                   static_cast<double>(tick.contacts), tick.micros});
    }
}

}  // namespace

Expected<Experiment> measureTouch(Subjects& subjects, StandardToothKind kind) {
    const auto tooth = subjects.tooth(kind);
    if (!tooth) return Unexpected{tooth.error()};
    const auto surface = plainSurface((*tooth)->mesh);
    const Figure figure = figureOf(kind);
    Experiment experiment{figure.id, "Depth, velocity and force: " + (*tooth)->name,
                          "",        {"mm_per_s", "t", "depth", "velocity", "force", "contacts", "micros"},
                          {},        2,
                          {},        {}};
    experiment.method = "The hand comes down on the " + (*tooth)->name + " (" + (*tooth)->source + ", " +
                        std::to_string((*tooth)->mesh.triangles.size()) +
                        " triangles), is pressed 0.3 mm in, slides to and fro and leaves, at low (1 cm/s) and at high "
                        "speed (10 cm/s), turning the bur 60 degrees/s about its tip.";
    std::array<Run, 2> runs = {Run{kSlowHand, {}}, Run{kFastHand, {}}};
    for (Run& run : runs) {
        HandPath path;
        path.speed = run.speed;
        path.strokes = 2;
        run.ticks = feelPath(subjects.bur(), surface, handPath((*tooth)->mesh, path), kRepeat);
        addRows(experiment, run);
    }
    struct Curve {
        const char* title;
        const char* unit;
        double (*value)(const Tick&);
    };
    const std::array<Curve, 3> curves = {{{"Depth", "mm", [](const Tick& t) { return t.depth; }},
                                          {"Velocity of the tip", "mm/s", [](const Tick& t) { return t.speed; }},
                                          {"Force", "N", [](const Tick& t) { return t.wrench.force.norm(); }}}};
    for (const Curve& curve : curves) {
        for (const Run& run : runs) {
            const std::string at = ", " + shortNumber(run.speed / 10) + " cm/s";
            experiment.panels.push_back(panelOf(curve.title + at, curve.unit, run.ticks, curve.value));
        }
    }
    const auto ours = [](const Run& run) {
        const ForceMicros micros = forceMicros(run.ticks);
        return shortNumber(micros.p50) + " us (median), " + shortNumber(micros.p99) + " us (99 %)";
    };
    experiment.comparisons = {
        {"Time to compute a force, low speed", shortNumber(figure.published.slow) + " us", ours(runs[0])},
        {"Time to compute a force, high speed", shortNumber(figure.published.fast) + " us", ours(runs[1])}};
    return experiment;
}

}  // namespace tactooth
