// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "bench_scene.h"
#include "session/kernel/session_kernel.h"
#include "session/kernel/stepwise_session.h"

namespace tactooth {
namespace {

using test::at;

/// A block of dentin with soft decay, 2 mm wide and 0.8 mm deep, in its top.
std::shared_ptr<CutModel> decayedBlock() {
    std::vector<LayerMesh> layers;
    layers.push_back({"decay", test::kCaries, test::box(Vec3(-1, -1, -0.8), Vec3(1, 1, 0.2))});
    auto tooth = LayeredTooth::make(test::box(Vec3(-2, -2, -3), Vec3(2, 2, 0)), std::move(layers), test::kDentin);
    EXPECT_TRUE(tooth);
    return std::make_shared<CutModel>(std::make_shared<const LayeredTooth>(std::move(*tooth)), test::kVoxel);
}

struct Scraped {
    MaterialVolumes removed{};
    std::vector<SessionEvent> events;
    std::vector<Tick> ticks;
    std::uint64_t hash = 0;

    [[nodiscard]] double of(MaterialId id) const { return removed[static_cast<std::size_t>(id)]; }
};

/// To and fro over the block for some seconds, with the hand as far below the tool as `newton` want. Pedal and button
/// say "cut".
Scraped scrape(HandInstrument kind, double newton, double seconds, double reach = 0.8) {
    Scraped run;
    const auto model = decayedBlock();
    HapticSettings settings;
    StepwiseSession session(model, {handTool(kind), settings, Placement::AtOnce},
                            [&run](const SessionEvent& event) { run.events.push_back(event); });
    constexpr double kTick = 0.002;  // s
    double z = 0.3;
    for (double time = 0; time < seconds; time += kTick) {
        const double x = reach * std::sin(2 * M_PI * 1.5 * time), y = 0.3 * std::sin(2 * M_PI * 0.2 * time);
        const double spring =
            run.ticks.empty() || run.ticks.back().force.stiffness == 0 ? 1 : run.ticks.back().force.stiffness;
        const Tick tick = session.step({at(x, y, z - newton / spring), 1, true}, kTick, time);
        z = tick.contact.proxy.position.z();
        run.ticks.push_back(tick);
        (void)session.carve();
        session.list();
    }
    session.finish(true);
    run.removed = model->removed();
    run.hash = model->hash();
    return run;
}

TEST(HandInstruments, AnExcavatorTakesDecayAndNoSoundTissue) {
    const Scraped run = scrape(HandInstrument::Excavator, 1, 3, 1.5);
    EXPECT_GT(run.of(test::kCaries), 0.2);
    for (const MaterialId id : builtinMaterials().ids()) {
        if (id != test::kCaries) {
            EXPECT_EQ(run.of(id), 0) << builtinMaterials().nameOf(id);
        }
    }
}

TEST(HandInstruments, AnExcavatorTakesMoreWithMoreForce) {
    double before = 0;
    for (const double newton : {0.2, 0.5, 1.0}) {
        const double taken = scrape(HandInstrument::Excavator, newton, 1).of(test::kCaries);
        EXPECT_GT(taken, 1.3 * before) << newton;
        before = taken;
    }
}

TEST(HandInstruments, NothingTurnsAndOthersTakeNothing) {
    for (const HandInstrumentSpec& spec : handInstruments()) {
        const Scraped run = scrape(spec.kind, 0.5, 1);
        for (const Tick& tick : run.ticks) {
            ASSERT_FALSE(tick.input.cutting);
            ASSERT_EQ(tick.spindle.speedRpm, 0);
        }
        if (spec.kind != HandInstrument::Excavator) {
            EXPECT_EQ(total(run.removed), 0) << spec.name;
        }
    }
}

TEST(HandInstruments, ASessionIsReplayedBitForBit) {
    for (const HandInstrumentSpec& spec : handInstruments()) {
        const Scraped run = scrape(spec.kind, 0.7, 1.2);
        const auto model = decayedBlock();
        SessionKernel kernel(model);
        std::size_t ticks = 0;
        for (const SessionEvent& event : run.events) {
            ASSERT_TRUE(kernel.apply(event)) << spec.name << ", tick " << ticks;
            if (std::holds_alternative<ExactTickEvent>(event)) {
                ASSERT_EQ(kernel.tick().force.wrench.force, run.ticks[ticks].force.wrench.force);
                ASSERT_EQ(kernel.tick().force.tipHold, run.ticks[ticks].force.tipHold);
                ASSERT_EQ(kernel.tick().contact.pullOuts, run.ticks[ticks].contact.pullOuts);
                ASSERT_EQ(kernel.tick().contact.pullOutForce, run.ticks[ticks].contact.pullOutForce);
                ++ticks;
            }
        }
        EXPECT_EQ(ticks, run.ticks.size());
        EXPECT_EQ(model->hash(), run.hash) << spec.name;
    }
}

TEST(HandInstruments, WhatAnExcavatorTookIsUndone) {
    const Scraped run = scrape(HandInstrument::Excavator, 1, 1);
    const auto model = decayedBlock();
    const std::uint64_t whole = model->hash();
    SessionKernel kernel(model);
    for (const SessionEvent& event : run.events) ASSERT_TRUE(kernel.apply(event));
    ASSERT_GT(total(model->removed()), 0);
    EXPECT_TRUE(kernel.apply(EditEvent{Edit::Undo, true}));
    EXPECT_EQ(total(model->removed()), 0);
    EXPECT_EQ(model->hash(), whole);
}

}  // namespace
}  // namespace tactooth
