// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/simulation/cut_events.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "bench_scene.h"
#include "support/materials.h"

namespace tactooth {
namespace {

using test::at;

Tick tickAt(double z, int contacts, double speedRpm = 200000, double pedal = 1) {
    Tick tick;
    tick.contact.proxy = at(0, 0, z);
    tick.contact.triangles = contacts;
    tick.spindle.speedRpm = speedRpm;
    tick.input.pedal = pedal;
    tick.input.cutting = true;
    return tick;
}

ToothLoss gone(double enamel, double dentin, double pulp, std::size_t pieces = 0) {
    ToothLoss loss;
    loss.removed[static_cast<std::size_t>(test::kEnamel)] = enamel;
    loss.removed[static_cast<std::size_t>(test::kDentin)] = dentin;
    loss.removed[static_cast<std::size_t>(test::kPulp)] = pulp;
    loss.pieces = pieces;
    return loss;
}

TEST(CutEvents, AreReportedOnceInTheirOrderWithTimeAndPlace) {
    CutEvents events;
    events.update(0.0, tickAt(0.2, 0), gone(0, 0, 0));
    EXPECT_TRUE(events.all().empty());
    events.update(0.1, tickAt(0, 1), gone(0, 0, 0));
    events.update(0.2, tickAt(-0.5, 1), gone(0.3, 1e-5, 0));
    events.update(0.3, tickAt(-1, 1), gone(0.5, 0.1, 0));
    events.update(0.4, tickAt(-2, 1), gone(0.5, 0.4, 0.01));
    events.update(0.5, tickAt(-3, 1), gone(0.5, 0.5, 0.1));
    const std::vector<CutEventKind> kinds = {CutEventKind::FirstContact, CutEventKind::DentinReached,
                                             CutEventKind::PulpExposed};
    ASSERT_EQ(events.all().size(), kinds.size());
    for (std::size_t i = 0; i < kinds.size(); ++i) EXPECT_EQ(events.all()[i].kind, kinds[i]);
    EXPECT_EQ(events.all()[1].time, 0.3);
    EXPECT_EQ(events.all()[2].place, Vec3(0, 0, -2));
    EXPECT_EQ(cutEventName(events.all()[2].kind), "pulp exposed");
}

ToothLoss near(bool isNear) {
    ToothLoss loss = gone(1, 1, 0);
    loss.nearPulp = isNear ? 1 : 0;
    return loss;
}

TEST(CutEvents, ACutNearThePulpIsReportedOnce) {
    CutEvents events;
    events.update(0.0, tickAt(0, 0), near(false));
    events.update(0.1, tickAt(-2, 0), near(true));
    events.update(0.2, tickAt(-2, 0), near(true));
    events.update(0.3, tickAt(-1, 0), near(false));  // undone
    events.update(0.4, tickAt(-2, 0), near(true));
    ASSERT_EQ(events.all().size(), 1U);
    EXPECT_EQ(events.all()[0].kind, CutEventKind::PulpNear);
    EXPECT_EQ(events.all()[0].time, 0.1);
    EXPECT_EQ(events.all()[0].place, Vec3(0, 0, -2));
    EXPECT_EQ(cutEventsCsv(events.all()), "t,event,x,y,z\n0.1,pulp near,0,0,-2\n");
}

TEST(CutEvents, ACutNearThePulpThatWasThereBeforeIsReportedOnlyWhenItIsMadeAgain) {
    CutEvents events;
    events.update(0.0, tickAt(0, 0), near(true));
    events.update(0.1, tickAt(0, 0), near(true));
    EXPECT_TRUE(events.all().empty());
    events.update(0.2, tickAt(0, 0), near(false));
    events.update(0.3, tickAt(0, 0), near(true));
    EXPECT_EQ(events.all().size(), 1U);
}

TEST(CutEvents, WhatWasCutBeforeIsNotReported) {
    CutEvents events;
    events.update(0.0, tickAt(1, 0), gone(1, 1, 1));
    events.update(0.1, tickAt(1, 0), gone(1, 1, 1));
    EXPECT_TRUE(events.all().empty());
    events.update(0.2, tickAt(0, 1), gone(1, 1, 1.1));
    EXPECT_EQ(events.all().size(), 2U);
}

TEST(CutEvents, APieceThatCameLooseIsReportedEachTime) {
    CutEvents events;
    events.update(0.0, tickAt(1, 0), gone(1, 0, 0, 2));  // of an earlier session
    events.update(0.1, tickAt(1, 0), gone(2, 0, 0, 3));
    events.update(0.2, tickAt(1, 0), gone(2, 0, 0, 3));
    events.update(0.3, tickAt(1, 0), gone(1, 0, 0, 2));  // taken back
    events.update(0.4, tickAt(1, 0), gone(3, 0, 0, 4));
    std::vector<double> times;
    for (const CutEvent& event : events.all()) {
        if (event.kind == CutEventKind::FragmentReleased) times.push_back(event.time);
    }
    EXPECT_EQ(times, (std::vector<double>{0.1, 0.4}));
    EXPECT_EQ(cutEventName(CutEventKind::FragmentReleased), "piece came loose");
}

TEST(CutEvents, WhatIsPutBackAndCutAgainIsNotReportedAgain) {
    CutEvents events;
    events.update(0.0, tickAt(1, 0), gone(5, 1, 0.3));  // an undo comes a moment later
    events.update(0.1, tickAt(1, 0), gone(0, 0, 0));
    EXPECT_TRUE(events.all().empty());
    events.update(0.2, tickAt(0, 1), gone(0.2, 0, 0));
    events.update(0.3, tickAt(0, 1), gone(0.5, 0.1, 0.01));  // less than there was before the undo
    ASSERT_EQ(events.all().size(), 3U);
    EXPECT_EQ(events.all()[2].kind, CutEventKind::PulpExposed);
    EXPECT_EQ(events.all()[2].time, 0.3);
}

TEST(CutEvents, ReportEachTouchOfTheSurroundings) {
    CutEvents events;
    Tick tick = tickAt(0, 1);
    const auto update = [&](double time, std::optional<MaterialId> around) {
        tick.contact.around = around;
        events.update(time, tick, {});
    };
    update(0.0, {});
    update(0.1, test::kEnamel);
    update(0.2, {});             // the bur skips
    update(0.3, test::kDentin);  // its root
    update(0.4, test::kOther);
    update(0.9, {});
    update(1.0, test::kEnamel);
    std::vector<std::pair<CutEventKind, double>> found;
    for (const CutEvent& event : events.all()) found.emplace_back(event.kind, event.time);
    const std::vector<std::pair<CutEventKind, double>> expected = {{CutEventKind::FirstContact, 0.0},
                                                                   {CutEventKind::NeighbourTouched, 0.1},
                                                                   {CutEventKind::GingivaTouched, 0.4},
                                                                   {CutEventKind::NeighbourTouched, 1.0}};
    EXPECT_EQ(found, expected);
    EXPECT_EQ(cutEventsCsv(std::span(events.all()).subspan(1, 1)), "t,event,x,y,z\n0.1,neighbour touched,0,0,0\n");
}

TEST(CutEvents, ACutIntoTheSurroundingsIsReportedOnce) {
    CutEvents events;
    events.update(0.0, tickAt(0, 0), {.beside = 0.3});  // of an earlier session
    events.update(0.1, tickAt(0, 0), {.beside = 0.3});
    EXPECT_TRUE(events.all().empty());
    events.update(0.2, tickAt(0, 0), {.beside = 0.31});
    events.update(0.3, tickAt(0, 0), {.beside = 0.4});
    ASSERT_EQ(events.all().size(), 1U);
    EXPECT_EQ(events.all()[0].kind, CutEventKind::AdjacentCut);
    EXPECT_EQ(events.all()[0].time, 0.2);
    EXPECT_EQ(cutEventName(CutEventKind::AdjacentCut), "cut beside the tooth");
}

TEST(CutEvents, ANeighboursDentinIsNotThatOfTheTooth) {
    const auto lost = [](double dentin, double beside) {
        ToothLoss loss = gone(0, dentin, 0);
        loss.beside = beside;
        return loss;
    };
    CutEvents events;
    const auto isReached = [&] {
        return std::ranges::any_of(events.all(),
                                   [](const CutEvent& event) { return event.kind == CutEventKind::DentinReached; });
    };
    events.update(0.0, tickAt(0, 1), lost(0, 0));
    for (int i = 1; i < 50; ++i) events.update(0.01 * i, tickAt(0, 1), lost(0.01 * i, 0.0099 * i));
    EXPECT_FALSE(isReached()) << "what is left is the error of a surface's volume";
    CutEvents both = events;
    events.update(0.6, tickAt(0, 1), lost(0.49005, 0.4851));
    EXPECT_FALSE(isReached());
    events.update(0.7, tickAt(0, 1), lost(0.5, 0.4851));
    EXPECT_TRUE(isReached()) << "nothing has gone beside";
    both.update(0.6, tickAt(0, 1), lost(0.8, 0.6));
    EXPECT_EQ(both.all().back().kind, CutEventKind::DentinReached) << "more than all that has gone beside";
}

TEST(CutEvents, ABurStallsEachTimeThatItHadRunUpAndTheFootStaysDown) {
    CutEvents events;
    events.update(0.0, tickAt(0, 1, 0), {});  // has not run up yet
    EXPECT_EQ(events.all().size(), 1U);       // the contact
    events.update(0.1, tickAt(0, 1), {});
    events.update(0.2, tickAt(0, 1, 100), {});
    events.update(0.3, tickAt(0, 1, 0), {});
    EXPECT_EQ(events.all().size(), 2U);
    EXPECT_EQ(events.all().back().kind, CutEventKind::BurStalled);
    EXPECT_EQ(events.all().back().time, 0.2);
    events.update(0.4, tickAt(0, 1), {});
    events.update(0.5, tickAt(0, 1, 0, 0), {});  // the foot has let it run down
    events.update(0.6, tickAt(0, 1), {});
    events.update(0.7, tickAt(0, 1, 0), {});
    EXPECT_EQ(events.all().size(), 3U);
}

TEST(CutEvents, ADriveThatRunsDownBecauseCuttingIsOffDoesNotStall) {
    CutEvents events;
    Tick tick = tickAt(0, 1);
    events.update(0.0, tick, {});
    tick.input.cutting = false;
    tick.spindle.speedRpm = 0;
    events.update(0.1, tick, {});
    ASSERT_EQ(events.all().size(), 1U);
    EXPECT_EQ(events.all()[0].kind, CutEventKind::FirstContact);
}

TEST(CutEvents, TooMuchLoadStallsTheTurbine) {
    const auto piece = test::blockOnTheBench(test::kEnamel);
    HapticSettings settings;  // the air turbine
    settings.force = {.stiffness = 20.0, .damping = 0.0, .friction = 0.0};
    const Instrument bur = test::flatBur();
    HapticSimulation simulation(bur.shape, bur.cutting.envelope.maxRadius(), piece->surface(), settings);
    CutEvents events;
    double slowest = 1e9;
    for (int i = 0; i < 4000; ++i) {
        const double z = i < 2000 ? 0.2 : 0.2 - 0.001 * std::min(i - 2000, 800);  // runs up, then is pressed by 12 N
        const Tick tick = simulation.step({at(0, 0, z), 1, true}, 0.001);
        if (i >= 2000) slowest = std::min(slowest, tick.spindle.speedRpm);
        events.update(tick.time, tick, {});
    }
    EXPECT_EQ(slowest, 0);
    ASSERT_EQ(events.all().size(), 2U);
    EXPECT_EQ(events.all()[1].kind, CutEventKind::BurStalled);
    EXPECT_GT(events.all()[1].time, events.all()[0].time);
}

}  // namespace
}  // namespace tactooth
