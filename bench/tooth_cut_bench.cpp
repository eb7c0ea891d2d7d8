// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Cutting: time from a bur's move to the new surface (carve, extraction, snapshot). A bur of 1.2 mm plunges 2 mm into
// a tooth of some 325,000 triangles and then runs along a slot; each iteration is the move between two surface updates.
// Swept as far as the path goes, or as far as a given work suffices (feed).
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "milling.h"
#include "support/shapes.h"
#include "tooth/surface/incremental_surface.h"
#include "tooth/volume/bur_feed.h"

namespace tactooth {
namespace {

std::shared_ptr<const LayeredTooth> molar() {
    static const auto tooth = std::make_shared<const LayeredTooth>(std::move(*LayeredTooth::make(largeTooth())));
    return tooth;
}

const RevolutionEnvelope& fissureBur() {
    static const RevolutionEnvelope bur = *RevolutionEnvelope::make(test::cylinder(Vec3::Zero(), 0.6, 4.2, 96));
    return bur;
}

double percentile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return values.empty() ? 0 : values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

/// Arguments: voxel in um, feed in mm/s, updates a second.
void carveAndUpdate(benchmark::State& state) {
    const double voxel = 1e-3 * static_cast<double>(state.range(0));
    const double step = static_cast<double>(state.range(1)) / static_cast<double>(state.range(2));
    CutVolume volume(molar(), voxel);
    IncrementalSurface surface(volume);
    const Box3 box = molar()->outer()->tree().box();
    double length = 0;
    double removed = 0;
    std::vector<double> milliseconds;
    for (auto _ : state) {
        const auto begin = std::chrono::steady_clock::now();
        const CarveResult result =
            volume.carve(fissureBur(), poseAlongPath(box, length, 0), poseAlongPath(box, length + step, 0));
        surface.update(volume, result.changed);
        const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
        milliseconds.push_back(took.count());
        removed += total(result.removed);
        length += step;
    }
    state.counters["p50_ms"] = percentile(milliseconds, 0.5);
    state.counters["p99_ms"] = percentile(milliseconds, 0.99);
    state.counters["max_ms"] = percentile(milliseconds, 1);
    state.counters["removed_mm3"] = removed;
    state.counters["brick_MB"] = 1e-6 * static_cast<double>(volume.bytes());
}
BENCHMARK(carveAndUpdate)
    ->ArgNames({"voxel_um", "feed_mm_s", "rate_Hz"})
    ->Args({50, 1, 20})
    ->Args({50, 5, 20})
    ->Args({50, 5, 60})
    ->Args({25, 10, 60})
    ->Iterations(300)
    ->Unit(benchmark::kMillisecond);

/// Feeds toward a device that is always ahead, as far as the work suffices. Arguments: voxel in um, work that each
/// update may spend in mN*m.
void feedAndUpdate(benchmark::State& state) {
    const double voxel = 1e-3 * static_cast<double>(state.range(0));
    const double work = 1e-3 * static_cast<double>(state.range(1));
    constexpr double kAhead = 0.1;  // mm
    CutVolume volume(molar(), voxel);
    IncrementalSurface surface(volume);
    const Box3 box = molar()->outer()->tree().box();
    double length = 0.3;  // just above the tooth
    double lastFeedLength = 0;
    double removed = 0;
    std::vector<double> search, all;
    for (auto _ : state) {
        const auto begin = std::chrono::steady_clock::now();
        const double enough = std::max(2 * lastFeedLength, voxel) / kAhead;
        const FeedResult result = feedBur(volume, fissureBur(), poseAlongPath(box, length, 0),
                                          poseAlongPath(box, length + kAhead, 0), work, {}, 1, enough);
        const std::chrono::duration<double, std::milli> found = std::chrono::steady_clock::now() - begin;
        surface.update(volume, result.carve.changed);
        const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
        lastFeedLength = result.fraction * kAhead;
        length += lastFeedLength;
        removed += total(result.carve.removed);
        if (result.fraction == 1) continue;  // still in the air
        search.push_back(found.count());
        all.push_back(took.count());
    }
    state.counters["search_p50_ms"] = percentile(search, 0.5);
    state.counters["p50_ms"] = percentile(all, 0.5);
    state.counters["p99_ms"] = percentile(all, 0.99);
    state.counters["removed_mm3"] = removed;
}
BENCHMARK(feedAndUpdate)
    ->ArgNames({"voxel_um", "work_mNm"})
    ->Args({25, 100})
    ->Args({25, 1000})
    ->Iterations(300)
    ->Unit(benchmark::kMillisecond);

/// From a tooth without a brick to the first cut surface.
void firstCut(benchmark::State& state) {
    const Box3 box = molar()->outer()->tree().box();
    for (auto _ : state) {
        CutVolume volume(molar(), 0.05);
        IncrementalSurface surface(volume);
        const CarveResult result = volume.carve(fissureBur(), poseAlongPath(box, 1.5, 0), poseAlongPath(box, 1.6, 0));
        surface.update(volume, result.changed);
        benchmark::DoNotOptimize(surface.snapshot());
    }
}
BENCHMARK(firstCut)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tactooth

BENCHMARK_MAIN();
