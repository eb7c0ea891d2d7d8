// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/kernel/stepwise_session.h"

#include <gtest/gtest.h>

#include <vector>

#include "bench_scene.h"
#include "session/kernel/session_kernel.h"
#include "session/scripts/cut_run.h"
#include "session/scripts/touch_run.h"

namespace tactooth {
namespace {

using test::at;

/// A run and its events.
struct Recorded {
    std::vector<SessionEvent> events;
    std::vector<Tick> ticks;
    std::uint64_t hash = 0;
    double removed = 0;
};

StepwiseSession::EventSink into(Recorded& run) {
    return [&run](const SessionEvent& event) { run.events.push_back(event); };
}

/// To and fro in the block, with a lift in the middle: times that are no multiples of anything.
std::vector<TimedPose> strokes() {
    std::vector<TimedPose> path;
    for (int i = 0; i < 700; ++i) {
        const double time = 0.00103 * i;
        const double depth = i > 300 && i < 450 ? 0.5 : -0.3 - 0.0003 * i;
        path.push_back({time, at(0.9 * std::sin(9 * time), 0.1, depth)});
    }
    return path;
}

HapticSettings fastDrive() {
    HapticSettings settings;
    settings.spindle = constantSpeed(300'000);
    return settings;
}

Recorded cutByLaw() {
    Recorded run;
    const auto model = test::blockOnTheBench();
    StepwiseSession session(model, cutSetup(test::flatBur(), fastDrive()), into(run));
    EXPECT_TRUE(cutWithRemovalLaw(strokes(), session,
                                  [&](double, const Tick& tick, const ToothLoss&) { run.ticks.push_back(tick); }));
    run.hash = model->hash();
    run.removed = total(model->removed());
    return run;
}

Recorded cutRigidly(double speedRpm) {
    Recorded run;
    const auto model = test::blockOnTheBench();
    StepwiseSession session(model, rigidCutSetup(test::flatBur(), {}, speedRpm), into(run));
    EXPECT_TRUE(cutKinematically(strokes(), speedRpm > 0, session,
                                 [&](double, const Tick& tick, const ToothLoss&) { run.ticks.push_back(tick); }));
    run.hash = model->hash();
    run.removed = total(model->removed());
    return run;
}

/// Applies the events, and expects the same ticks and the same tooth.
void expectSameAgain(const Recorded& run, const std::shared_ptr<CutModel>& model) {
    SessionKernel kernel(model);
    std::size_t ticks = 0;
    for (const SessionEvent& event : run.events) {
        ASSERT_TRUE(kernel.apply(event)) << "after tick " << ticks;
        if (!secondsOf(event)) continue;
        const Tick& expected = run.ticks.at(ticks++);
        ASSERT_EQ(kernel.tick().number, ticks);
        ASSERT_EQ(kernel.tick().time, expected.time);
        ASSERT_EQ(kernel.tick().force.wrench.force, expected.force.wrench.force) << "tick " << ticks;
        ASSERT_EQ(kernel.tick().contact.proxy.position, expected.contact.proxy.position) << "tick " << ticks;
        ASSERT_EQ(kernel.tick().spindle.cutWork, expected.spindle.cutWork) << "tick " << ticks;
    }
    EXPECT_EQ(ticks, run.ticks.size());
    EXPECT_EQ(kernel.toothHash(), run.hash);
    EXPECT_EQ(total(kernel.model().removed()), run.removed);
}

TEST(StepwiseSession, ACutByTheLawIsTheSameFromItsEvents) {
    const Recorded run = cutByLaw();
    EXPECT_GT(run.removed, 0.05);
    expectSameAgain(run, test::blockOnTheBench());
}

TEST(StepwiseSession, ARigidCutIsTheSameFromItsEvents) {
    const Recorded run = cutRigidly(200'000);
    EXPECT_GT(run.removed, 0.1);
    expectSameAgain(run, test::blockOnTheBench());
    EXPECT_EQ(cutRigidly(0).removed, 0) << "a bur that stands still";
    expectSameAgain(cutRigidly(0), test::blockOnTheBench());
    expectSameAgain(cutRigidly(0.25), test::blockOnTheBench());
}

TEST(StepwiseSession, WhoListensChangesNothing) {
    const Recorded run = cutByLaw();
    const auto model = test::blockOnTheBench();
    StepwiseSession alone(model, cutSetup(test::flatBur(), fastDrive()));
    EXPECT_TRUE(cutWithRemovalLaw(strokes(), alone, [](double, const Tick&, const ToothLoss&) {}));
    EXPECT_EQ(model->hash(), run.hash);
}

std::shared_ptr<CutModel> openSquare() {
    TriangleMesh square;
    square.vertices = {Vec3f(-2, -2, 0), Vec3f(2, -2, 0), Vec3f(2, 2, 0), Vec3f(-2, 2, 0)};
    square.triangles = {{0, 1, 2}, {0, 2, 3}};
    auto part = std::make_shared<const SurfacePart>(std::move(square));
    return std::make_shared<CutModel>(
        std::make_shared<const LayeredTooth>(LayeredTooth::touchOnly(std::move(part), false)), 0.05);
}

/// A flat tool, which no bur can be.
Instrument flatTool() {
    TriangleMesh plate;
    plate.vertices = {Vec3f(-1, -1, 0), Vec3f(1, -1, 0), Vec3f(0, 1, 0)};
    plate.triangles = {{0, 2, 1}};
    return touchingTool(std::make_shared<const ToolShape>(std::move(plate)));
}

TEST(StepwiseSession, AnOpenSurfaceIsTouchedAgain) {
    Recorded run;
    StepwiseSession session(openSquare(), {flatTool(), {}, Placement::AtOnce}, into(run));
    std::vector<TimedPose> path;
    for (int i = 0; i < 100; ++i) path.push_back({0.001 * i, at(0, 0, 0.2 - 0.005 * i)});
    double most = 0;
    ASSERT_TRUE(runTouchPath(path, session, [&](double, const Tick& tick) {
        run.ticks.push_back(tick);
        most = std::max(most, tick.force.wrench.force.z());
    }));
    EXPECT_GT(most, 0.05);
    run.hash = openSquare()->hash();
    expectSameAgain(run, openSquare());
}

TEST(SessionKernel, CutsNothingThatIsOnlyTouched) {
    for (const bool isToolDull : {true, false}) {
        SessionKernel kernel(isToolDull ? test::blockOnTheBench() : openSquare());
        ASSERT_TRUE(kernel.apply(BeginEvent{isToolDull ? flatTool() : test::flatBur(), {}, Placement::AtOnce}));
        EXPECT_TRUE(kernel.apply(ExactTickEvent{{at(0, 0, 1), 1, true}, 0, 0, false, 0}));
        EXPECT_FALSE(kernel.apply(CarveEvent{1, false}));
        EXPECT_FALSE(kernel.apply(FinishEvent{true, false}));
        EXPECT_FALSE(kernel.apply(ExactTickEvent{{at(0, 0, 1), 1, true}, 0, 0, true, 0})) << "a sweep";
    }
}

TEST(SessionKernel, RefusesExactTicksThatNoRunHas) {
    const double nan = std::nan("");
    const Pose pose = at(0, 0, 1);
    const Pose far{Vec3(nan, 0, 0), Quat::Identity()};
    for (const ExactTickEvent& event :
         {ExactTickEvent{{pose, 1, true}, -1, 0, false, 0}, ExactTickEvent{{pose, 1, true}, nan, 0, false, 0},
          ExactTickEvent{{pose, 1, true}, 0, nan, false, 0}, ExactTickEvent{{pose, 1, true}, 0, 0, false, 1},
          ExactTickEvent{{far, 1, true}, 0, 0, true, 0}}) {
        SessionKernel kernel(test::blockOnTheBench());
        ASSERT_TRUE(kernel.apply(BeginEvent{test::flatBur(), {}, Placement::AtOnce}));
        EXPECT_FALSE(kernel.apply(event));
    }
}

TEST(StepwiseSession, EndsEarlyWhenAsked) {
    std::stop_source stop;
    int rows = 0;
    StepwiseSession session(test::blockOnTheBench(), cutSetup(test::flatBur(), fastDrive()));
    EXPECT_TRUE(cutWithRemovalLaw(
        strokes(), session,
        [&](double, const Tick&, const ToothLoss&) {
            if (++rows == 10) stop.request_stop();
        },
        stop.get_token()));
    EXPECT_EQ(rows, 10);
}

}  // namespace
}  // namespace tactooth
