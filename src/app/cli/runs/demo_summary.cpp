// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/runs/demo_summary.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "haptics/latency_histogram.h"

namespace tactooth {

std::string demoSummary(const Demonstration& demonstration, const CutModel& piece, const std::string& tooth,
                        const std::string& bur) {
    LatencyHistogram micros;
    double peak = 0;
    double sum = 0;
    double deepest = 0;
    double fastest = 0;
    std::size_t touching = 0;
    for (const Tick& tick : demonstration.ticks) {
        const double force = tick.force.wrench.force.norm();
        micros.add(tick.diagnostics.micros);
        peak = std::max(peak, force);
        deepest = std::max(deepest, tick.contact.depth);
        fastest = std::max(fastest, tick.spindle.speedRpm);
        if (tick.contact.triangles > 0) ++touching, sum += force;
    }
    nlohmann::ordered_json removed;
    const MaterialRegistry& materials = piece.tooth().materials();
    for (const MaterialId id : materials.ids()) {
        removed[materials.nameOf(id)] = piece.removed()[static_cast<std::size_t>(id)];
    }
    auto events = nlohmann::ordered_json::array();
    for (const auto& [kind, time, place, isTakenBack] : demonstration.events) {
        events.push_back({{"t", time}, {"event", cutEventName(kind)}, {"place", {place.x(), place.y(), place.z()}}});
    }
    const Surface& surface = *piece.surface();
    const nlohmann::ordered_json summary = {
        {"tooth", tooth},
        {"bur", bur},
        {"seconds", demonstration.ticks.empty() ? 0.0 : demonstration.ticks.back().time},
        {"ticks", demonstration.ticks.size()},
        {"touching_ticks", touching},
        {"largest_depth_mm", deepest},
        {"largest_force_N", peak},
        {"mean_force_touching_N", touching > 0 ? sum / static_cast<double>(touching) : 0.0},
        {"largest_speed_rpm", fastest},
        {"removed_mm3", removed},
        {"removed_beside_mm3", piece.loss().beside},
        {"events", events},
        {"surface_updates", demonstration.surfaceUpdates},
        {"surface_patches", surface.patches.size()},
        {"tick_us", {{"p50", micros.quantile(0.5)}, {"p99", micros.quantile(0.99)}, {"max", micros.largest()}}},
    };
    return summary.dump(2) + "\n";
}

}  // namespace tactooth
