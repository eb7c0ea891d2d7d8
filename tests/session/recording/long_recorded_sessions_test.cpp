// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// A hundred random sessions of all threads, recorded into files and replayed: burs, drives, modes, rates, undo, redo,
// reset, devices of both hands, half of them with all cores busy.
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <random>
#include <thread>

#include "bench_scene.h"
#include "devices/simulated/scripted_device.h"
#include "session/live/live_runner.h"
#include "session/recording/session_recorder.h"
#include "session/recording/session_recording.h"
#include "session/recording/session_replay.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

using namespace std::chrono_literals;
using test::at;

/// All that a user would see, feel or be judged by.
struct Outcome {
    std::vector<std::array<double, 10>> ticks;  ///< force, torque, position of the bur, depth
    std::uint64_t hash = 0;
    MaterialVolumes removed{};
    TaggedMesh surface;
};

std::array<double, 10> numbersOf(const Tick& tick) {
    const Vec3& force = tick.force.wrench.force;
    const Vec3& torque = tick.force.wrench.torque;
    const Vec3& place = tick.contact.proxy.position;
    return {force.x(),  force.y(), force.z(), torque.x(), torque.y(),
            torque.z(), place.x(), place.y(), place.z(),  tick.contact.depth};
}

Outcome outcomeOf(std::vector<std::array<double, 10>> ticks, const CutModel& model) {
    return {std::move(ticks), model.hash(), model.removed(), model.exported()};
}

class RecordedSession {
public:
    RecordedSession(unsigned seed, const std::filesystem::path& file) : random_(seed), file_(file) {}

    Outcome run() {
        const std::shared_ptr<CutModel> model =
            test::blockOnTheBench(random_() % 2 == 0 ? test::kCaries : test::kDentin);
        auto recorder = SessionRecorder::create(file_, *model, "block");
        EXPECT_TRUE(recorder) << recorder.error().message();
        std::vector<std::array<double, 10>> ticks;
        for (unsigned bur = 0, burs = 1 + random_() % 3; bur < burs; ++bur) runBur(model, **recorder, ticks);
        const auto closed = (*recorder)->close(model->hash());
        EXPECT_TRUE(closed) << closed.error().message();
        return outcomeOf(std::move(ticks), *model);
    }

private:
    [[nodiscard]] double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }

    [[nodiscard]] Instrument randomBur() {
        const TriangleMesh mesh = test::cylinder(Vec3::Zero(), between(0.25, 0.6), 4, 16 + random_() % 32);
        return {std::make_shared<const ToolShape>(mesh), {*RevolutionEnvelope::make(mesh), between(0.3, 1)}};
    }

    [[nodiscard]] HapticSettings randomSettings() {
        HapticSettings settings;
        settings.freedom = random_() % 2 == 0 ? Freedom::Translation : Freedom::TranslationAndRotation;
        if (random_() % 6 == 0) settings.mode = ContactMode::Penalty;
        settings.spindle = spindlePresets()[random_() % spindlePresets().size()];
        if (random_() % 3 == 0) settings.force.stiffness = between(0.5, 3);
        return settings;
    }

    [[nodiscard]] std::vector<DeviceKeyframe> randomHand(double seconds) {
        std::vector<DeviceKeyframe> hand = {{0, {at(0, 0, 0.4), 1, 0, true}}};
        for (double time = 0.05; time < seconds; time += between(0.03, 0.2)) {
            Pose pose = at(between(-1.3, 1.3), between(-1.3, 1.3), between(-0.9, 0.5));
            pose.rotation = Quat(1, between(-0.2, 0.2), between(-0.2, 0.2), between(-0.2, 0.2)).normalized();
            hand.push_back({time, {pose, random_() % 6 == 0 ? 0.0 : between(0.2, 1), 0, random_() % 20 != 0}});
        }
        return hand;
    }

    void runBur(const std::shared_ptr<CutModel>& model, SessionRecorder& recorder,
                std::vector<std::array<double, 10>>& ticks) {
        constexpr std::array kRates = {500.0, 1000.0, 2000.0, 4000.0};
        const double seconds = between(0.3, 0.9);
        const Instrument bur = randomBur();
        const HapticSettings settings = randomSettings();
        ScriptedDevice device(randomHand(seconds)), second(randomHand(seconds));
        const bool hasSecond = random_() % 4 == 0;
        const auto lanes = recorder.begin({bur, settings});
        std::vector<std::jthread> load;
        for (unsigned i = 0; i < 2 * (random_() % 2); ++i) {
            load.emplace_back([](const std::stop_token& stop) {
                volatile double x = 1;
                while (!stop.stop_requested()) x = x + 1;
            });
        }
        ticks.reserve(ticks.size() + 10'000);
        {
            LiveRunner runner(
                model, bur, settings, device, [&](const Tick& tick) { ticks.push_back(numbersOf(tick)); },
                kRates[random_() % kRates.size()], {}, hasSecond ? &second : nullptr, {}, lanes);
            SessionControls controls;
            controls.force = settings.force;
            const auto start = std::chrono::steady_clock::now();
            constexpr std::uint64_t kLeast = 60;  // ticks, also where a busy machine leaves out many
            while (std::chrono::steady_clock::now() - start < std::chrono::duration<double>(seconds) ||
                   runner.feed().timing().ticks < kLeast) {
                controls.cutting = random_() % 5 != 0;
                controls.clutch = random_() % 10 == 0;
                controls.forceScale = random_() % 3 == 0 ? between(0, 1.5) : 1;
                runner.setControls(controls);
                if (random_() % 4 == 0) {
                    runner.request(std::array{Edit::Undo, Edit::Undo, Edit::Redo, Edit::Reset}[random_() % 4]);
                }
                // The pace of the user, who waits for nothing.
                std::this_thread::sleep_for(std::chrono::duration<double>(between(0.02, 0.15)));
            }
        }
        recorder.end();
    }

    std::mt19937 random_;
    std::filesystem::path file_;
};

void expectExactReplay(unsigned seed) {
    SCOPED_TRACE("session " + std::to_string(seed));
    const test::TemporaryFolder folder;
    const Outcome live = RecordedSession(seed, folder / "s.ttsession").run();
    const auto recording = SessionRecording::open(folder / "s.ttsession");
    ASSERT_TRUE(recording) << recording.error().message();
    EXPECT_TRUE(recording->journal().isComplete());
    auto replay = SessionReplay::start(*recording);
    ASSERT_TRUE(replay) << replay.error().message();
    std::vector<std::array<double, 10>> ticks;
    const auto played = replay->playUntil({}, [&](double, const Tick& tick) { ticks.push_back(numbersOf(tick)); });
    ASSERT_TRUE(played) << played.error().message();
    ASSERT_FALSE(replay->differsAt()) << "at " << *replay->differsAt() << " s";
    const Outcome replayed = outcomeOf(std::move(ticks), replay->model());
    ASSERT_EQ(replayed.ticks.size(), live.ticks.size());
    EXPECT_EQ(replayed.ticks, live.ticks);
    EXPECT_EQ(replayed.hash, live.hash);
    EXPECT_EQ(replayed.removed, live.removed);
    EXPECT_EQ(replayed.surface.mesh.vertices, live.surface.mesh.vertices);
    EXPECT_EQ(replayed.surface.mesh.triangles, live.surface.mesh.triangles);
    EXPECT_EQ(replayed.surface.tags, live.surface.tags);
    EXPECT_GT(live.ticks.size(), 50U);
}

class LongRecordedSessions : public testing::TestWithParam<unsigned> {};
INSTANTIATE_TEST_SUITE_P(Tens, LongRecordedSessions, testing::Range(0U, 10U));

TEST_P(LongRecordedSessions, ReplayBitForBit) {
    constexpr unsigned kSessions = 10;
    for (unsigned i = 0; i < kSessions && !HasFailure(); ++i) expectExactReplay(kSessions * GetParam() + i);
}

}  // namespace
}  // namespace tactooth
