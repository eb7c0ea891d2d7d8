// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/recording/session_recording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <thread>

#include "bench_scene.h"
#include "devices/simulated/scripted_device.h"
#include "session/live/live_runner.h"
#include "session/recording/event_codec.h"
#include "session/recording/session_recorder.h"
#include "session/recording/session_replay.h"
#include "support/shapes.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using test::at;
using ::testing::HasSubstr;

/// A tooth of two layers among others: a wall that is felt and cannot be cut.
std::shared_ptr<CutModel> toothAmongOthers() {
    TriangleMesh outer = test::box(Vec3(-1.5, -1.5, -3), Vec3(1.5, 1.5, 0));
    std::vector<LayerMesh> layers;
    layers.push_back({"enamel", test::kEnamel, outer});
    layers.push_back({"caries", test::kCaries, test::box(Vec3(-1, -1, -2), Vec3(1, 1, -0.1))});
    auto tooth = LayeredTooth::make(std::move(outer), std::move(layers));
    auto model = std::make_shared<CutModel>(std::make_shared<const LayeredTooth>(std::move(*tooth)), test::kVoxel);
    TriangleMesh wall = test::box(Vec3(1.6, -1.5, -3), Vec3(3, 1.5, 1));
    std::vector<SurfaceTag> tags(wall.triangles.size(), static_cast<SurfaceTag>(test::kOther));
    model->surroundBy({std::make_shared<const SurfacePart>(std::move(wall), std::move(tags), 0)});
    return model;
}

std::vector<DeviceKeyframe> strokes(double seconds, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> across(-1.3, 1.8), down(-0.8, 0.4);
    std::vector<DeviceKeyframe> script = {{0, {at(0, 0, 0.4), 1, 0, true}}};
    for (double time = 0.1; time < seconds; time += 0.12) {
        script.push_back({time, {at(across(random), across(random), down(random)), 1, 0, true}});
    }
    return script;
}

struct Recorded {
    std::vector<double> forces;  ///< along z, of each tick
    std::uint64_t hash = 0;
    TaggedMesh tooth;
};

/// Two burs, one after the other, with an undo.
Recorded record(const fs::path& file, double secondsEach) {
    Recorded result;
    const std::shared_ptr<CutModel> model = toothAmongOthers();
    auto recorder = SessionRecorder::create(file, *model, "test tooth");
    EXPECT_TRUE(recorder) << recorder.error().message();
    for (int bur = 0; bur < 2; ++bur) {
        HapticSettings settings;
        settings.freedom = bur == 0 ? Freedom::Translation : Freedom::TranslationAndRotation;
        const Instrument instrument = test::flatBur(bur == 0 ? 1 : 0.5);
        ScriptedDevice device(strokes(secondsEach, 40 + static_cast<unsigned>(bur)));
        const auto lanes = (*recorder)->begin({instrument, settings});
        {
            SessionControls controls;
            controls.cutting = true;
            LiveRunner runner(
                model, instrument, settings, device,
                [&](const Tick& tick) { result.forces.push_back(tick.force.wrench.force.z()); }, 1000, {}, nullptr,
                controls, lanes);
            std::this_thread::sleep_for(std::chrono::duration<double>(secondsEach));
            if (bur == 0) runner.request(Edit::Undo);
        }
        (*recorder)->end();
    }
    result.hash = model->hash();
    result.tooth = model->exported();
    const auto closed = (*recorder)->close(result.hash);
    EXPECT_TRUE(closed) << closed.error().message();
    return result;
}

TEST(SessionRecording, ReplaysFromTheFileBitForBit) {
    const test::TemporaryFolder folder;
    const Recorded live = record(folder / "s.ttsession", 1.5);
    const auto recording = SessionRecording::open(folder / "s.ttsession");
    ASSERT_TRUE(recording) << recording.error().message();
    EXPECT_TRUE(recording->journal().isComplete());
    EXPECT_EQ(recording->facts().title, "test tooth");
    EXPECT_EQ(recording->ticks(), live.forces.size());
    auto replay = SessionReplay::start(*recording);
    ASSERT_TRUE(replay) << replay.error().message();
    std::vector<double> forces;
    const auto played =
        replay->playUntil({}, [&](double, const Tick& tick) { forces.push_back(tick.force.wrench.force.z()); });
    ASSERT_TRUE(played) << played.error().message();
    EXPECT_FALSE(replay->differsAt()) << *replay->differsAt();
    EXPECT_EQ(forces, live.forces);
    EXPECT_EQ(replay->model().hash(), live.hash);
    EXPECT_EQ(replay->model().exported().mesh.vertices, live.tooth.mesh.vertices);
    EXPECT_EQ(replay->model().exported().mesh.triangles, live.tooth.mesh.triangles);
}

TEST(SessionRecording, StopsAtAMoment) {
    const test::TemporaryFolder folder;
    (void)record(folder / "s.ttsession", 0.6);
    const auto recording = SessionRecording::open(folder / "s.ttsession");
    ASSERT_TRUE(recording) << recording.error().message();
    auto replay = SessionReplay::start(*recording);
    ASSERT_TRUE(replay) << replay.error().message();
    ASSERT_TRUE(replay->playUntil(0.25, {}));
    EXPECT_LE(replay->seconds(), 0.25);
    EXPECT_GT(replay->seconds(), 0.1);
}

/// What a crash leaves: the file, cut off anywhere.
TEST(SessionRecording, OfAnyLengthOpensAndReplaysWhatIsLeft) {
    const test::TemporaryFolder folder;
    (void)record(folder / "s.ttsession", 0.8);
    const auto whole = fs::file_size(folder / "s.ttsession");
    const auto recorded = SessionRecording::open(folder / "s.ttsession");
    ASSERT_TRUE(recorded) << recorded.error().message();
    const auto& blocks = recorded->journal().blocks();
    const auto first =
        std::ranges::find(blocks, BlockType::Events, [](const auto& block) { return block.header.type; });
    ASSERT_NE(first, blocks.end());
    std::mt19937 random(7);
    int played = 0;
    for (int i = 0; i < 12; ++i) {
        const fs::path file = folder / "cut.ttsession";
        fs::copy_file(folder / "s.ttsession", file, fs::copy_options::overwrite_existing);
        fs::resize_file(file, first->offset + random() % (whole - first->offset));
        const auto recording = SessionRecording::open(file);
        ASSERT_TRUE(recording) << recording.error().message();
        EXPECT_FALSE(recording->journal().isComplete());
        auto replay = SessionReplay::start(*recording);
        ASSERT_TRUE(replay) << replay.error().message();
        const auto done = replay->playUntil({}, {});
        ASSERT_TRUE(done) << done.error().message();
        EXPECT_FALSE(replay->differsAt());
        EXPECT_EQ(replay->ticks(), recording->ticks());
        played += replay->ticks() > 0 ? 1 : 0;
    }
    EXPECT_GT(played, 3);
}

/// A number that no session has, where the event has room for it.
SessionEvent hostile(SessionEvent event, std::mt19937& random) {
    constexpr std::array<std::int64_t, 6> kNumbers = {std::numeric_limits<std::int64_t>::max(),
                                                      std::numeric_limits<std::int64_t>::min(),
                                                      std::int64_t{1} << 40,
                                                      -1,
                                                      0,
                                                      1'000'000};
    const std::int64_t number = kNumbers[random() % kNumbers.size()];
    if (auto* tick = std::get_if<TickEvent>(&event)) {
        switch (random() % 6) {
            case 0:
                tick->input.position[random() % 3] = number;
                break;
            case 1:
                tick->input.rotation[random() % 4] = static_cast<std::int32_t>(number);
                break;
            case 2:
                tick->input.elapsed = static_cast<std::int32_t>(number);
                break;
            case 3:
                tick->input.pedal = static_cast<std::int32_t>(number);
                break;
            case 4:
                tick->taken = static_cast<std::uint32_t>(number);
                break;
            default:
                tick->input.rotation = {0, 0, 0, 0};
        }
    } else if (auto* carve = std::get_if<CarveEvent>(&event)) {
        carve->tick = static_cast<TickNumber>(number);
    } else if (auto* list = std::get_if<ListEvent>(&event)) {
        (random() % 2 == 0 ? list->tick : list->surface) = static_cast<std::uint32_t>(number);
        list->recycled = static_cast<std::uint32_t>(number);
    } else if (auto* force = std::get_if<ForceEvent>(&event)) {
        force->parameters.overrides.stiffness = random() % 2 == 0 ? 1e300 : 0.0;
        force->parameters.overrides.friction = 1e300;
        force->parameters.scale = random() % 2 == 0 ? 1e300 : -1;
    }
    return event;
}

/// Whoever made the file: it is refused, or it is played with finite forces until it differs.
TEST(SessionRecording, HostileEventsDoNoHarm) {
    const test::TemporaryFolder folder;
    (void)record(folder / "s.ttsession", 0.4);
    const auto recording = SessionRecording::open(folder / "s.ttsession");
    ASSERT_TRUE(recording) << recording.error().message();
    std::vector<SessionEvent> events;
    ASSERT_TRUE(recording->forEach([&](const SessionEvent& event) { return events.push_back(event), true; }));
    std::mt19937 random(11);
    constexpr int kRounds = 25;
    int refused = 0;
    for (int round = 0; round < kRounds; ++round) {
        SessionKernel kernel(*recording->makeModel());
        const std::size_t first = random() % events.size();
        bool goesOn = true;
        for (std::size_t i = 0; i < events.size() && goesOn; ++i) {
            if (std::holds_alternative<BeginEvent>(events[i])) {
                ASSERT_TRUE(kernel.apply(events[i]));
                continue;
            }
            const SessionEvent event = i >= first && i < first + 30 ? hostile(events[i], random) : events[i];
            const auto read = decodeEvents(encodeEvents(std::span(&event, 1)));
            if (!read) continue;
            goesOn = kernel.apply(read->front());
            refused += goesOn ? 0 : 1;
            ASSERT_TRUE(kernel.tick().force.wrench.force.allFinite());
            ASSERT_TRUE(kernel.tick().force.wrench.torque.allFinite());
            ASSERT_TRUE(kernel.tick().contact.proxy.position.allFinite());
            ASSERT_TRUE(std::isfinite(kernel.tick().spindle.speedRpm));
        }
    }
    EXPECT_GT(refused, kRounds / 2);
}

/// More ticks than a queue holds come at once. What is before is replayed, and nothing that comes later.
TEST(SessionRecording, AFullQueueEndsIt) {
    const test::TemporaryFolder folder;
    const auto file = folder / "s.ttsession";
    const std::shared_ptr<CutModel> model = toothAmongOthers();
    auto recorder = SessionRecorder::create(file, *model, "test tooth");
    ASSERT_TRUE(recorder) << recorder.error().message();
    const BeginEvent bur{test::flatBur(1), HapticSettings{}};
    auto lanes = (*recorder)->begin(bur);
    TickEvent tick;
    tick.input.rotation[3] = static_cast<std::int32_t>(1 / TickInput::kRotationStep);
    tick.input.elapsed = 1 << 10;  // about a millisecond
    tick.input.hasPose = true;
    tick.input.position[2] = static_cast<std::int64_t>(5 / TickInput::kPositionStep);  // above the tooth
    std::size_t sent = 0;
    for (; sent < 10'000'000 && !lanes->hasOverflowed(); ++sent) lanes->servo(tick);
    ASSERT_TRUE(lanes->hasOverflowed());
    lanes = (*recorder)->begin(bur);  // another bur is taken
    for (int i = 0; i < 100; ++i) lanes->servo(tick);
    const auto closed = (*recorder)->close(model->hash() + 1);  // nobody can reach what was cut beyond the gap
    ASSERT_FALSE(closed);
    EXPECT_THAT(closed.error().message(), HasSubstr("The recording has a gap"));

    const auto recording = SessionRecording::open(file);
    ASSERT_TRUE(recording) << recording.error().message();
    EXPECT_TRUE(recording->end().value().hasGap);
    EXPECT_FALSE(recording->end().value().toothHash);
    EXPECT_LT(recording->ticks(), sent);
    EXPECT_GE(recording->ticks(), 1U << 14);
    int begins = 0;
    ASSERT_TRUE(recording->forEach([&](const SessionEvent& event) {
        begins += std::holds_alternative<BeginEvent>(event) ? 1 : 0;
        return true;
    }));
    EXPECT_EQ(begins, 1);
    auto replay = SessionReplay::start(*recording);
    ASSERT_TRUE(replay) << replay.error().message();
    ASSERT_TRUE(replay->playUntil(2.0, [](double, const Tick&) {}));
    EXPECT_FALSE(replay->differsAt());
}

TEST(SessionRecording, AFileThatIsNoRecordingHasItsSentence) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "s.ttsession") << "not a recording";
    const auto recording = SessionRecording::open(folder / "s.ttsession");
    ASSERT_FALSE(recording);
    EXPECT_THAT(recording.error().message(), HasSubstr("s.ttsession"));
}

TEST(SessionRecorder, WithoutAFolderHasItsSentence) {
    const test::TemporaryFolder folder;
    const auto recorder = SessionRecorder::create(folder / "missing/s.ttsession", *toothAmongOthers(), "t");
    ASSERT_FALSE(recorder);
    EXPECT_THAT(recorder.error().message(), HasSubstr("missing"));
}

}  // namespace
}  // namespace tactooth
