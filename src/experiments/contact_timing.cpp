// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/contact_timing.h"

#include <algorithm>
#include <limits>

#include "experiments/quantile.h"
#include "experiments/thread_clock.h"

namespace tactooth {

ToolTrajectory standardToolPath(double speed) {
    ToolTrajectory path;
    path.speed = speed;
    path.strokes = speed > 50 ? 12 : 4;  // some thousand ticks either way
    return path;
}

std::shared_ptr<const Surface> plainSurface(TriangleMesh mesh) {
    auto surface = std::make_shared<Surface>();
    surface->base = std::make_shared<const SurfacePart>(std::move(mesh));
    return surface;
}

ContactTiming timeContact(const std::shared_ptr<const Surface>& surface, const std::shared_ptr<const ToolShape>& tool,
                          std::span<const Pose> devicePath, int repeat, Freedom freedom) {
    std::vector<double> micros(devicePath.size(), std::numeric_limits<double>::infinity());
    std::vector<MoveResult> results(devicePath.size());
    for (int run = 0; run < repeat; ++run) {
        ProxySolver solver(tool, freedom);
        solver.setSurface(surface);
        solver.placeAt(devicePath.front());
        for (std::size_t i = 0; i < devicePath.size(); ++i) {
            const double start = threadMicros();
            results[i] = solver.moveToward(devicePath[i]);
            micros[i] = std::min(micros[i], threadMicros() - start);
        }
    }
    ContactTiming timing;
    timing.ticks = devicePath.size();
    std::vector<double> inContact;
    for (std::size_t i = 0; i < devicePath.size(); ++i) {
        timing.iterationLimitHits += results[i].status == MoveStatus::OutOfIterations ? 1 : 0;
        timing.overlapping += results[i].status == MoveStatus::Overlapping ? 1 : 0;
        timing.largest = std::max(timing.largest, micros[i]);
        if (results[i].contactCount == 0) continue;
        inContact.push_back(micros[i]);
        timing.contacts += results[i].contactCount;
        timing.iterations += results[i].iterations;
        timing.distances += results[i].distances;
    }
    timing.inContact = inContact.size();
    for (double* sum : {&timing.contacts, &timing.iterations, &timing.distances}) {
        *sum /= std::max<double>(1, static_cast<double>(timing.inContact));
    }
    timing.p50 = quantile(inContact, 0.5);
    timing.p99 = quantile(inContact, 0.99);
    timing.p999 = quantile(inContact, 0.999);
    return timing;
}

}  // namespace tactooth
