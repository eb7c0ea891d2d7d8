// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>

#include "experiments/contact_timing.h"
#include "experiments/experiments.h"
#include "experiments/published.h"
#include "experiments/touch_simulation.h"
#include "geometry/util/number_text.h"
#include "haptics/tool_proxy.h"

namespace tactooth {
namespace {

// The published table ends at 0.1 um; two finer steps are added.
constexpr std::array kMovements = {100.0, 50.0, 10.0, 5.0, 1.0, 0.5, 0.1, 0.01, 0.001};  // um
constexpr int kSteps = 8;       // of each size, one after the other
constexpr double kPerMm = 1e3;  // um
constexpr int kCoarse = 12;     // percent: the resolutions of the published 0.1 um
constexpr int kRepeat = 3;      // for the time of a force
constexpr double kStart = 0.1;  // mm: depth from which the hand moves on

/// A moment of the standard path with the bur pressed in, not far from the middle of the path.
Pose pressedPose(std::span<const Pose> devicePath, std::span<const Tick> ticks) {
    for (std::size_t i = 2 * ticks.size() / 5; i < ticks.size(); ++i) {
        if (ticks[i].contact.triangles > 0 && ticks[i].contact.depth > kStart) return devicePath[i];
    }
    return devicePath[devicePath.size() / 2];
}

struct Noticed {
    int steps = 0;      // that made the contact deeper
    double change = 0;  // mean of the depth over all steps, um
};

/// Moves the hand further in, against the force, step by step.
Noticed moveFurther(HapticSimulation simulation, Pose device, double step) {
    constexpr double kTick = ToolProxy::kTick;
    constexpr int kSettle = 10;  // ticks in which the hand stands still
    Tick before;
    for (int i = 0; i < kSettle; ++i) before = simulation.step({device, 0, false}, kTick);
    const double start = before.contact.depth;
    const Vec3 inward = -before.contact.normal;
    Noticed noticed;
    for (int i = 0; i < kSteps; ++i) {
        device.position += step * inward;
        const Tick now = simulation.step({device, 0, false}, kTick);
        noticed.steps += now.contact.depth > before.contact.depth ? 1 : 0;
        before = now;
    }
    noticed.change = kPerMm * (before.contact.depth - start) / kSteps;
    return noticed;
}

/// The smallest movement that was noticed at every step, as were all larger ones; infinite if there is none.
double leastNoticed(std::span<const Noticed> noticed) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < noticed.size() && noticed[i].steps == kSteps; ++i) least = kMovements[i];
    return least;
}

struct AtResolution {
    std::array<Noticed, kMovements.size()> noticed;
    ForceTiming force;
};

AtResolution measureAt(const TriangleMesh& mesh, const std::shared_ptr<const ToolShape>& bur) {
    const auto surface = plainSurface(mesh);
    const std::vector<Pose> devicePath = toolTrajectory(mesh, standardToolPath(kSlowSpeed));
    const std::vector<Tick> ticks = touchPath(bur, surface, devicePath, kRepeat);
    const Pose pressed = pressedPose(devicePath, ticks);
    HapticSimulation arrived = enamelSimulation(bur, surface);
    for (const Pose& pose : devicePath) {
        (void)arrived.step({pose, 0, false}, 1e-3);
        if (pose.position == pressed.position) break;
    }
    AtResolution result;
    for (std::size_t i = 0; i < kMovements.size(); ++i) {
        result.noticed[i] = moveFurther(arrived, pressed, kMovements[i] / kPerMm);
    }
    result.force = forceMicros(ticks);
    return result;
}

/// Change of depth by size of the step, over all teeth and resolutions.
class Extremes {
public:
    void take(std::span<const Noticed> noticed) {
        for (std::size_t i = 0; i < noticed.size(); ++i) {
            least_[i] = std::min(least_[i], noticed[i].change);
            greatest_[i] = std::max(greatest_[i], noticed[i].change);
        }
    }

    [[nodiscard]] ExperimentPlot plot() const {
        ExperimentPlot plot{"Change of depth a step, all teeth, 6 to 100 %",
                            "movement of the hand, um",
                            "um",
                            true,
                            true,
                            {{"greatest", {}, true, false}, {"least", {}, true, false}}};
        for (std::size_t i = 0; i < kMovements.size(); ++i) {
            if (greatest_[i] > 0) plot.series[0].points.push_back({kMovements[i], greatest_[i]});
            if (least_[i] > 0) plot.series[1].points.push_back({kMovements[i], least_[i]});
        }
        for (const double limit : {published::kMinMovement, published::kMinMovementCoarse}) {
            plot.series.push_back(
                {"published limit, " + std::string(limit == published::kMinMovement ? "25 to 100 %" : "6, 12 %"),
                 {{limit, kMovements.back()}, {limit, kMovements.front()}},
                 false,
                 true});
        }
        return plot;
    }

private:
    std::array<double, kMovements.size()> least_ = filled(std::numeric_limits<double>::infinity());
    std::array<double, kMovements.size()> greatest_ = filled(0);

    static std::array<double, kMovements.size()> filled(double value) {
        std::array<double, kMovements.size()> all{};
        all.fill(value);
        return all;
    }
};

void addRow(Experiment& experiment, const std::string& tooth, const Resolution& resolution, const AtResolution& found) {
    std::vector<Cell> row = {tooth, static_cast<double>(resolution.percent),
                             static_cast<double>(resolution.mesh.triangles.size())};
    for (const Noticed& noticed : found.noticed) row.emplace_back(static_cast<double>(noticed.steps) / kSteps);
    for (const Noticed& noticed : found.noticed) row.emplace_back(noticed.change);
    row.emplace_back(found.force.p50);
    row.emplace_back(found.force.p99);
    experiment.rows.push_back(std::move(row));
}

std::vector<std::string> columnNames() {
    std::vector<std::string> names = {"tooth", "percent", "triangles"};
    for (const double movement : kMovements) names.push_back("noticed_" + numberText(movement) + "um");
    for (const double movement : kMovements) names.push_back("change_um_" + numberText(movement) + "um");
    names.emplace_back("force_p50_us");
    names.emplace_back("force_p99_us");
    return names;
}

}  // namespace

Expected<Experiment> measureMovement(TestTeeth& testTeeth) {
    Experiment experiment{"table4", "Smallest movement, and time to compute a force", "", columnNames(), {}, 2, {}, {}};
    experiment.method =
        "The bur is pressed into the tooth; then the hand moves further in, against the force, eight times by the same "
        "step. A step is noticed if the depth grows. The time is that of the tick (contact and force law) on the "
        "standard path at 1 cm/s, ticks in contact, processor time, least of three runs.";
    Extremes extremes;
    ExperimentPlot time{"Time to compute a force (median)", "triangles", "us", true, true, {}};
    double least = 0, leastCoarse = 0;  // um: the greatest of the smallest movements noticed
    double shortest = std::numeric_limits<double>::infinity(), longest = 0;
    for (const StandardToothKind kind : kStandardTeeth) {
        const auto ladder = testTeeth.ladder(kind);
        if (!ladder) return Unexpected{ladder.error()};
        const std::string name = (*testTeeth.tooth(kind))->name;
        PlotSeries times{name, {}, true, false};
        for (const Resolution& resolution : **ladder) {
            const AtResolution found = measureAt(resolution.mesh, testTeeth.bur());
            addRow(experiment, name, resolution, found);
            times.points.push_back({static_cast<double>(resolution.mesh.triangles.size()), found.force.p50});
            shortest = std::min(shortest, found.force.p50);
            longest = std::max(longest, found.force.p50);
            least = std::max(least, leastNoticed(found.noticed));
            if (resolution.percent <= kCoarse) leastCoarse = std::max(leastCoarse, leastNoticed(found.noticed));
            extremes.take(found.noticed);
        }
        time.series.push_back(times);
    }
    using namespace published;
    time.series.push_back({"published, least and greatest",
                           {{kMinTriangles, kShortestForce}, {kMaxTriangles, kLongestForce}},
                           true,
                           true});
    experiment.panels = {extremes.plot(), time};
    experiment.comparisons = {{"Smallest movement noticed at every resolution of every tooth",
                               numberText(kMinMovement) + " um", shortNumber(least) + " um"},
                              {"Smallest movement noticed at 6 and 12 %", numberText(kMinMovementCoarse) + " um",
                               shortNumber(leastCoarse) + " um"},
                              {"Time to compute a force, from and to (medians)",
                               numberText(kShortestForce) + " to " + numberText(kLongestForce) + " us",
                               shortNumber(shortest) + " to " + shortNumber(longest) + " us"}};
    return experiment;
}

}  // namespace tactooth
