// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The servo thread must not wait for the heap: counts each call of operator new in this program.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "haptics/force_pipeline.h"
#include "haptics/haptic_simulation.h"
#include "instruments/bur_shape.h"
#include "scene.h"
#include "support/heap_counter.h"
#include "support/materials.h"
#include "support/servo_tick.h"
#include "tooth/surface/incremental_surface.h"

namespace tactooth {
namespace {

using Surfaces = std::vector<std::shared_ptr<const Surface>>;

constexpr int kSteps = 10000;
using test::kTick;

Bur roundBur() { return makeBur(*findBur("4")); }

HapticSimulation simulationOn(std::shared_ptr<const Surface> surface, ContactMode mode) {
    HapticSettings settings;
    settings.mode = mode;
    const Bur bur = roundBur();
    return {std::make_shared<const ToolShape>(bur.surface), bur.spec.headDiameter / 2, std::move(surface), settings};
}

/// A device that circles over the block and presses into it, and lifts off now and then.
OperatorInput circling(int step, bool cuts) {
    const double angle = 0.002 * step;
    const Vec3 tip(1.5 * std::cos(angle), 1.5 * std::sin(angle), 0.1 - 0.3 * std::sin(0.01 * step));
    return {{tip, Quat(Eigen::AngleAxisd(0.3 * std::sin(angle), Vec3::UnitX()))}, 1, cuts};
}

/// The surfaces of a slot that is being cut along the circle of the device.
Surfaces slotInTheMaking(int stages) {
    auto tooth = LayeredTooth::make(test::box(Vec3(-3, -3, -2), Vec3(3, 3, 0)), {}, test::kDentin);
    CutVolume volume(std::make_shared<const LayeredTooth>(std::move(*tooth)), 0.05);
    IncrementalSurface live(volume);
    const RevolutionEnvelope envelope = *RevolutionEnvelope::make(roundBur().surface);
    Surfaces surfaces = {live.snapshot()};
    for (int i = 0; i < stages; ++i) {
        const auto poseAt = [&](int stage) {
            const double angle = 0.1 * stage;
            return test::at(1.5 * std::cos(angle), 1.5 * std::sin(angle), -0.1);
        };
        live.update(volume, volume.carve(envelope, poseAt(i), poseAt(i + 1)).changed);
        surfaces.push_back(live.snapshot());
    }
    return surfaces;
}

TEST(Allocation, CounterSeesAnAllocation) {
    const long before = test::heapCalls();
    const std::vector<int> some(3);
    EXPECT_EQ(some.size(), 3U);
    EXPECT_GT(test::heapCalls(), before);
}

TEST(Allocation, TouchingUsesNoHeap) {
    for (const ContactMode mode : {ContactMode::Proxy, ContactMode::Penalty}) {
        HapticSimulation simulation = simulationOn(test::block(), mode);
        ForcePipeline pipeline{ForceLimits{}};
        simulation.step(circling(0, false), kTick);
        int touched = 0;
        const long before = test::heapCalls();
        for (int i = 1; i <= kSteps; ++i) {
            const Tick tick = simulation.step(circling(i, false), kTick);
            (void)pipeline.pass(forceCommandFrom(tick), kTick);
            touched += tick.contact.triangles > 0;
        }
        EXPECT_EQ(test::heapCalls(), before);
        EXPECT_GT(touched, kSteps / 3);
    }
}

TEST(Allocation, AHandInTheToothThatWaitsForAPlaceUsesNoHeap) {
    HapticSimulation simulation = simulationOn(test::block(), ContactMode::Proxy);
    simulation.deferPlacement();
    simulation.step({test::at(0, 0, -0.3), 1, true}, kTick);
    const long before = test::heapCalls();
    for (int i = 1; i <= kSteps / 10; ++i) {
        ASSERT_FALSE(simulation.step({test::at(0.001 * i, 0, -0.3), 1, true}, kTick).contact.placed);
    }
    EXPECT_EQ(test::heapCalls(), before);
}

TEST(Allocation, CuttingUsesNoHeapWhileTheSurfaceChanges) {
    constexpr int kStages = 60;
    Surfaces surfaces = slotInTheMaking(kStages);
    Surfaces retired;
    retired.reserve(surfaces.size());
    HapticSimulation simulation = simulationOn(surfaces[0], ContactMode::Proxy);
    simulation.step(circling(0, true), kTick);
    int touched = 0;
    int lost = 0;
    const long before = test::heapCalls();
    for (int i = 1; i <= kSteps; ++i) {
        if (i % (kSteps / kStages) == 0 && retired.size() < kStages) {
            retired.push_back(simulation.setSurface(std::move(surfaces[retired.size() + 1])));
        }
        const Tick tick = simulation.step(circling(i, true), kTick);
        touched += tick.contact.triangles > 0;
        lost += !tick.contact.placed;
    }
    EXPECT_EQ(test::heapCalls(), before);
    EXPECT_GT(touched, kSteps / 3);
    EXPECT_EQ(lost, 0);
}

}  // namespace
}  // namespace tactooth
