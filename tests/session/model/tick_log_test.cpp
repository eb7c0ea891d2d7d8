// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/tick_log.h"

#include <gtest/gtest.h>

#include "support/materials.h"

namespace tactooth {
namespace {

Tick tickAt(double time, int contacts = 0) {
    Tick tick;
    tick.time = time;
    tick.contact.triangles = contacts;
    return tick;
}

void record(TickLog& log, std::vector<Tick> ticks) { log.record(ticks, {}); }

TEST(TickLog, BeginsEmpty) {
    const TickLog log;
    EXPECT_TRUE(log.ticks().empty());
    EXPECT_TRUE(log.events().all().empty());
    EXPECT_EQ(log.workSeconds(), 0);
}

TEST(TickLog, KeepsTheTicksOfTheLastStepOnly) {
    TickLog log;
    record(log, {tickAt(0.001), tickAt(0.002)});
    record(log, {tickAt(0.003)});
    ASSERT_EQ(log.ticks().size(), 1U);
    EXPECT_EQ(log.newest().time, 0.003);
}

TEST(TickLog, AStepWithoutTicksKeepsTheNewest) {
    TickLog log;
    record(log, {tickAt(0.001), tickAt(0.002)});
    record(log, {});
    EXPECT_TRUE(log.ticks().empty());
    EXPECT_EQ(log.newest().time, 0.002);
}

TEST(TickLog, WorkBeginsWithTheFirstContact) {
    TickLog log;
    record(log, {tickAt(1)});
    EXPECT_EQ(log.workSeconds(), 0);
    record(log, {tickAt(2, 3), tickAt(5)});
    ASSERT_EQ(log.events().all().size(), 1U);
    EXPECT_EQ(log.events().all().front().time, 2);
    EXPECT_EQ(log.workSeconds(), 3);
}

TEST(TickLog, AnotherRunnerGoesOnInTimeThoughItsTicksStartAtZero) {
    TickLog log;
    record(log, {tickAt(2, 1), tickAt(5)});
    log.restart({});
    EXPECT_EQ(log.newest().time, 0);
    EXPECT_EQ(log.workSeconds(), 3);
    record(log, {tickAt(1)});
    EXPECT_EQ(log.workSeconds(), 4);
    log.restart({});
    record(log, {tickAt(0.5)});
    EXPECT_EQ(log.workSeconds(), 4.5);
    EXPECT_EQ(log.events().all().front().time, 2);
}

TEST(TickLog, TheFirstTickOfARestartIsTheGivenOne) {
    TickLog log;
    Tick start;
    start.input.cutting = true;
    start.contact.proxy.position = Vec3(1, 2, 3);
    log.restart(start);
    EXPECT_TRUE(log.newest().input.cutting);
    EXPECT_EQ(log.newest().contact.proxy.position, Vec3(1, 2, 3));
}

TEST(TickLog, ClearedEventsBeginAgainAtTheNewestTick) {
    TickLog log;
    record(log, {tickAt(2, 1), tickAt(5)});
    log.clearEvents();
    EXPECT_TRUE(log.events().all().empty());
    EXPECT_EQ(log.workSeconds(), 0);
    record(log, {tickAt(6, 1), tickAt(8)});
    EXPECT_EQ(log.events().all().front().time, 1) << "since the events were cleared";
    EXPECT_EQ(log.workSeconds(), 2);
}

TEST(TickLog, EventsOfTheLossAreReported) {
    TickLog log;
    record(log, {tickAt(1)});
    ToothLoss loss;
    loss.removed[static_cast<std::size_t>(test::kDentin)] = 1;
    std::vector<Tick> ticks{tickAt(2)};
    log.record(ticks, loss);
    ASSERT_EQ(log.events().all().size(), 2U);
    EXPECT_EQ(log.events().all()[1].kind, CutEventKind::DentinReached);
}

}  // namespace
}  // namespace tactooth
