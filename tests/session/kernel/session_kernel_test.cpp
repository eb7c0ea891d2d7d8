// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/kernel/session_kernel.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <chrono>
#include <random>
#include <thread>

#include "bench_scene.h"
#include "devices/simulated/scripted_device.h"
#include "session/kernel/event_merger.h"
#include "session/live/live_runner.h"

namespace tactooth {
namespace {

using namespace std::chrono_literals;
using test::at;

/// What a live session has reported, in the order of the recorder.
struct LiveSession {
    std::vector<SessionEvent> events;
    std::vector<Tick> ticks;
    std::uint64_t toothHash = 0;
    TaggedMesh tooth;
    std::size_t waiting = 0;
    bool overflowed = false;
};

struct Script {
    std::vector<DeviceKeyframe> hand;
    HapticSettings settings;
    double rateHz = 1000;
    double seconds = 1;
    std::vector<std::pair<double, Edit>> edits;  ///< s, ascending
    bool cutting = true;
};

DeviceKeyframe moment(double time, const Pose& hand, double pedal = 1) { return {time, {hand, pedal, 0, true}}; }

/// Goes to and fro over the block, in and out of it, turned a little, with the pedal up now and then.
Script randomScript(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> across(-1.3, 1.3), down(-0.7, 0.5), turn(-0.2, 0.2), part(0, 1);
    Script script;
    script.hand.push_back(moment(0, at(0, 0, 0.4)));
    double time = 0.05;
    while (time < script.seconds) {
        Pose pose = at(across(random), across(random), down(random));
        pose.rotation = Quat(1, turn(random), turn(random), turn(random)).normalized();
        script.hand.push_back(moment(time, pose, part(random) < 0.85 ? 1 : 0));
        time += 0.03 + 0.15 * part(random);
    }
    constexpr double kRates[] = {500, 1000, 2000, 4000};
    script.rateHz = kRates[random() % 4];
    script.settings.freedom = random() % 2 == 0 ? Freedom::Translation : Freedom::TranslationAndRotation;
    script.settings.spindle = spindlePresets()[random() % spindlePresets().size()];
    if (random() % 3 == 0) script.settings.force.stiffness = 2.0;
    const int edits = static_cast<int>(random() % 6);
    for (int i = 0; i < edits; ++i) {
        script.edits.emplace_back(script.seconds * (i + part(random)) / edits,
                                  std::array{Edit::Reset, Edit::Undo, Edit::Redo}[random() % 3]);
    }
    script.cutting = random() % 8 != 0;
    return script;
}

/// Runs all threads, for as long as the script lasts.
LiveSession runLive(const Script& script, const std::shared_ptr<CutModel>& model) {
    LiveSession session;
    const auto lanes = std::make_shared<EventLanes>();
    EventMerger merger;
    session.events.emplace_back(BeginEvent{test::flatBur(), script.settings});
    ScriptedDevice device(script.hand);
    {
        session.ticks.reserve(static_cast<std::size_t>(2 * script.rateHz * script.seconds) + 1000);
        SessionControls controls;
        controls.cutting = script.cutting;
        controls.force = script.settings.force;
        LiveRunner runner(
            model, test::flatBur(), script.settings, device, [&](const Tick& tick) { session.ticks.push_back(tick); },
            script.rateHz, {}, nullptr, controls, lanes);
        const auto start = std::chrono::steady_clock::now();
        std::size_t edits = 0;
        for (double time = 0; time < script.seconds;) {
            std::this_thread::sleep_for(5ms);
            time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            for (; edits < script.edits.size() && script.edits[edits].first < time; ++edits) {
                runner.request(script.edits[edits].second);
                controls.forceScale = 1 / static_cast<double>(1 + edits);
                runner.setControls(controls);
            }
            lanes->drain(merger);
            merger.take(session.events);
        }
    }
    lanes->drain(merger);
    merger.take(session.events);
    session.waiting = merger.waiting();
    session.overflowed = lanes->hasOverflowed();
    session.toothHash = model->hash();
    session.tooth = model->exported();
    return session;
}

std::uint64_t bitsOf(double value) { return std::bit_cast<std::uint64_t>(value); }

void expectSame(const Tick& live, const Tick& replayed) {
    ASSERT_EQ(live.number, replayed.number);
    ASSERT_EQ(bitsOf(live.time), bitsOf(replayed.time));
    for (int axis = 0; axis < 3; ++axis) {
        ASSERT_EQ(bitsOf(live.input.device.position[axis]), bitsOf(replayed.input.device.position[axis]));
        ASSERT_EQ(bitsOf(live.contact.proxy.position[axis]), bitsOf(replayed.contact.proxy.position[axis]));
        ASSERT_EQ(bitsOf(live.force.wrench.force[axis]), bitsOf(replayed.force.wrench.force[axis]));
        ASSERT_EQ(bitsOf(live.force.wrench.torque[axis]), bitsOf(replayed.force.wrench.torque[axis]));
    }
    ASSERT_EQ(live.contact.proxy.rotation.coeffs(), replayed.contact.proxy.rotation.coeffs());
    ASSERT_EQ(bitsOf(live.contact.depth), bitsOf(replayed.contact.depth));
    ASSERT_EQ(bitsOf(live.spindle.cutWork), bitsOf(replayed.spindle.cutWork));
    ASSERT_EQ(bitsOf(live.spindle.speedRpm), bitsOf(replayed.spindle.speedRpm));
    ASSERT_EQ(live.contact.triangles, replayed.contact.triangles);
    ASSERT_EQ(live.contact.placed, replayed.contact.placed);
    ASSERT_EQ(live.diagnostics.ownListRebuilds, replayed.diagnostics.ownListRebuilds);
}

void expectExactReplay(const LiveSession& live, const std::shared_ptr<CutModel>& model) {
    ASSERT_FALSE(live.overflowed);
    ASSERT_EQ(live.waiting, 0U) << "all has come";
    SessionKernel kernel(model);
    std::size_t ticks = 0;
    for (std::size_t i = 0; i < live.events.size(); ++i) {
        ASSERT_TRUE(kernel.apply(live.events[i]))
            << "event " << i << " of kind " << live.events[i].index() << ", tick " << kernel.tick().number;
        if (!std::holds_alternative<TickEvent>(live.events[i])) continue;
        ASSERT_LT(ticks, live.ticks.size());
        ASSERT_NO_FATAL_FAILURE(expectSame(live.ticks[ticks], kernel.tick())) << "tick " << ticks;
        ++ticks;
    }
    EXPECT_EQ(ticks, live.ticks.size());
    EXPECT_EQ(kernel.toothHash(), live.toothHash);
    const TaggedMesh tooth = kernel.model().exported();
    EXPECT_EQ(tooth.mesh.vertices, live.tooth.mesh.vertices);
    EXPECT_EQ(tooth.mesh.triangles, live.tooth.mesh.triangles);
}

class RandomSession : public ::testing::TestWithParam<unsigned> {};

TEST_P(RandomSession, OfAllThreadsReplaysBitForBit) {
    const LiveSession live = runLive(randomScript(GetParam()), test::blockOnTheBench(test::kCaries));
    ASSERT_NO_FATAL_FAILURE(expectExactReplay(live, test::blockOnTheBench(test::kCaries)));
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomSession, ::testing::Range(1U, 9U));

/// Twenty strokes that end in a deep slot: many surfaces and lists reach the servo thread late.
TEST(SessionKernel, ReplaysAHeavyCutWithAllCoresBusy) {
    Script script;
    script.settings.freedom = Freedom::TranslationAndRotation;
    script.seconds = 2;
    script.hand = {moment(0, at(-0.5, 0, 0.3)), moment(0.2, at(-0.5, 0, -0.5))};
    for (int i = 1; i <= 20; ++i) script.hand.push_back(moment(0.2 + 0.1 * i, at(i % 2 ? 0.5 : -0.5, 0, -0.05 * i)));
    std::vector<std::jthread> load;
    for (int i = 0; i < 3; ++i) {
        load.emplace_back([](const std::stop_token& stop) {
            volatile double x = 1;
            while (!stop.stop_requested()) x = x + 1;
        });
    }
    const LiveSession live = runLive(script, test::blockOnTheBench(test::kCaries));
    load.clear();
    ASSERT_NO_FATAL_FAILURE(expectExactReplay(live, test::blockOnTheBench(test::kCaries)));
    EXPECT_NE(live.toothHash, test::blockOnTheBench(test::kCaries)->hash()) << "something was cut";
}

/// A hand that begins inside the tooth waits for the pose that the neighbour-list thread finds.
TEST(SessionKernel, ReplaysAStartInsideTheTooth) {
    Script script;
    script.hand = {moment(0, at(0, 0, -0.4)), moment(0.5, at(0, 0, -0.4)), moment(0.7, at(0, 0, 0.5))};
    const LiveSession live = runLive(script, test::blockOnTheBench());
    ASSERT_NO_FATAL_FAILURE(expectExactReplay(live, test::blockOnTheBench()));
}

/// One flipped bit anywhere is found by a hash, or by the kernel itself.
TEST(SessionKernel, ADifferentInputGivesAnotherHash) {
    const LiveSession live = runLive(randomScript(3), test::blockOnTheBench(test::kCaries));
    SessionKernel same(test::blockOnTheBench(test::kCaries));
    for (const SessionEvent& event : live.events) ASSERT_TRUE(same.apply(event));
    std::mt19937 random(5);
    int found = 0;
    constexpr int kTries = 5;
    for (int i = 0; i < kTries; ++i) {
        std::vector<SessionEvent> events = live.events;
        TickEvent* changed = nullptr;
        while (changed == nullptr) changed = std::get_if<TickEvent>(&events[random() % events.size()]);
        changed->input.position[random() % 3] += 1;
        SessionKernel other(test::blockOnTheBench(test::kCaries));
        bool applied = true;
        for (const SessionEvent& event : events) applied = applied && other.apply(event);
        found += !applied || other.tickHash() != same.tickHash() ? 1 : 0;
    }
    EXPECT_EQ(found, kTries);
}

TEST(SessionKernel, RefusesEventsThatCannotFollow) {
    const auto begun = [] {
        auto kernel = std::make_unique<SessionKernel>(test::blockOnTheBench());
        EXPECT_TRUE(kernel->apply(BeginEvent{test::flatBur(), HapticSettings()}));
        return kernel;
    };
    const TickInput up = TickInput::of({at(0, 0, 1)}, 0.001);
    EXPECT_FALSE(SessionKernel(test::blockOnTheBench()).apply(TickEvent{up})) << "nothing has begun";
    EXPECT_FALSE(begun()->apply(BeginEvent{{nullptr, test::flatBur().cutting}, HapticSettings()})) << "no bur";
    EXPECT_FALSE(begun()->apply(TickEvent{up, 1})) << "no surface was sent";
    EXPECT_FALSE(begun()->apply(CarveEvent{1, false})) << "there is no tick 1 yet";
    EXPECT_FALSE(begun()->apply(ListEvent{1, 0, 0, false}));
    EXPECT_FALSE(begun()->apply(ListEvent{0, 1, 0, false})) << "no surface was published";
    EXPECT_FALSE(begun()->apply(ListEvent{0, 0, 1, false})) << "nothing to recycle";
    EXPECT_FALSE(begun()->apply(EditEvent{Edit::Undo, true})) << "there was nothing to undo";
    TickInput backwards = up;
    backwards.elapsed = -1;
    EXPECT_FALSE(begun()->apply(TickEvent{backwards}));
    const auto kernel = begun();
    EXPECT_TRUE(kernel->apply(TickEvent{up}));
    EXPECT_TRUE(kernel->apply(TickEvent{up}));
    EXPECT_TRUE(kernel->apply(CarveEvent{2, false}));
    EXPECT_FALSE(kernel->apply(CarveEvent{1, false})) << "it has seen a later one";
}

TEST(SessionKernel, SurvivesAnyEvents) {
    std::mt19937 random(9);
    const auto number = [&] { return static_cast<std::uint32_t>(random() % 4); };
    int refused = 0;
    for (int run = 0; run < 200; ++run) {
        SessionKernel kernel(test::blockOnTheBench());
        ASSERT_TRUE(kernel.apply(BeginEvent{test::flatBur(), HapticSettings()}));
        for (int i = 0; i < 50; ++i) {
            TickInput input;
            input.hasPose = random() % 4 != 0;
            for (auto& part : input.position) part = static_cast<std::int64_t>(random() % 20000) - 10000;
            for (auto& part : input.rotation) part = static_cast<std::int32_t>(random() % (1 << 24));
            input.elapsed = static_cast<std::int32_t>(random() % 3000);
            input.pedal = static_cast<std::int32_t>(random());
            const SessionEvent events[] = {TickEvent{input, number() / 3}, CarveEvent{number(), random() % 2 == 0},
                                           EditEvent{static_cast<Edit>(random() % 2), random() % 2 == 0},
                                           ListEvent{number(), number(), number(), random() % 2 == 0}};
            if (kernel.apply(events[random() % 4])) continue;
            ++refused;
            break;
        }
    }
    EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace tactooth
