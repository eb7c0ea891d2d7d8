// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "collision/proxy/contact_query.h"
#include "experiments/contact_timing.h"
#include "experiments/experiments.h"
#include "experiments/published.h"
#include "experiments/touch_simulation.h"
#include "geometry/util/assert.h"
#include "geometry/util/number_text.h"

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
            return {"fig15", published::kAnteriorTooth};
        case StandardToothKind::Canine:
            return {"fig16", published::kCanine};
        case StandardToothKind::Molar:
            return {"fig17", published::kMolar};
        case StandardToothKind::Large:
            break;
    }
    TACTOOTH_ASSERT(false);
    return {};
}

/// One curve over time.
ExperimentPlot panelOf(const std::string& title, const std::string& unit, std::span<const Tick> ticks,
                       double (*value)(const Tick&)) {
    ExperimentPlot panel{title, "time, ms", unit, false, false, {{"", {}, false, false}}};
    for (const Tick& tick : ticks) panel.series[0].points.push_back({1e3 * tick.time, value(tick)});
    return panel;
}

struct Run {
    double speed;  // mm/s
    std::vector<Tick> ticks;
};

void addRows(Experiment& experiment, const Run& run) {
    for (const Tick& tick : run.ticks) {
        experiment.rows.push_back({run.speed, tick.time, tick.contact.depth, tick.input.speed,
                                   tick.force.wrench.force.norm(), static_cast<double>(tick.contact.triangles),
                                   tick.diagnostics.micros});
    }
}

/// At how many ticks the proxy stood in the tooth, of all ticks with contact.
struct Reliability {
    std::size_t inside = 0;
    std::size_t touching = 0;
};

Reliability watchProxy(const std::shared_ptr<const Surface>& surface, const std::shared_ptr<const ToolShape>& bur) {
    Reliability found;
    ContactQuery query(bur, surface);
    for (const double speed : {10.0, 66.0, 100.0, 250.0, 500.0, 1000.0}) {
        const std::vector<Pose> devicePath = toolTrajectory(surface->base->mesh(), standardToolPath(speed));
        for (const Tick& tick : touchPath(bur, surface, devicePath, 1)) {
            if (tick.contact.triangles == 0) continue;
            ++found.touching;
            found.inside += query.isFree(tick.contact.proxy) ? 0 : 1;
        }
    }
    return found;
}

}  // namespace

Expected<Experiment> measureTouch(TestTeeth& testTeeth, StandardToothKind kind) {
    const auto tooth = testTeeth.tooth(kind);
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
    std::array<Run, 2> runs = {Run{kSlowSpeed, {}}, Run{kFastSpeed, {}}};
    for (Run& run : runs) {
        ToolTrajectory path;
        path.speed = run.speed;
        path.strokes = 2;
        run.ticks = touchPath(testTeeth.bur(), surface, toolTrajectory((*tooth)->mesh, path), kRepeat);
        addRows(experiment, run);
    }
    struct Curve {
        const char* title;
        const char* unit;
        double (*value)(const Tick&);
    };
    const std::array<Curve, 3> curves = {{{"Depth", "mm", [](const Tick& t) { return t.contact.depth; }},
                                          {"Velocity of the tip", "mm/s", [](const Tick& t) { return t.input.speed; }},
                                          {"Force", "N", [](const Tick& t) { return t.force.wrench.force.norm(); }}}};
    for (const Curve& curve : curves) {
        for (const Run& run : runs) {
            const std::string at = ", " + numberText(run.speed / 10) + " cm/s";
            experiment.panels.push_back(panelOf(curve.title + at, curve.unit, run.ticks, curve.value));
        }
    }
    const auto ours = [](const Run& run) {
        const ForceTiming micros = forceMicros(run.ticks);
        return shortNumber(micros.p50) + " us (median), " + shortNumber(micros.p99) + " us (99 %)";
    };
    const Reliability reliability = watchProxy(surface, testTeeth.bur());
    experiment.comparisons = {
        {"Time to compute a force, low speed", numberText(figure.published.slow) + " us", ours(runs[0])},
        {"Time to compute a force, high speed", numberText(figure.published.fast) + " us", ours(runs[1])},
        {"Greatest speed of the tip with reliable contact", numberText(published::kReliableOnTeeth / 10) + " cm/s",
         "at 1 to 100 cm/s the proxy stood in the tooth at " + std::to_string(reliability.inside) + " of " +
             std::to_string(reliability.touching) + " ticks"}};
    return experiment;
}

}  // namespace tactooth
