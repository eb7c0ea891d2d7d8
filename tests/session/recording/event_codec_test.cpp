// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/recording/event_codec.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>

namespace tactooth {
namespace {

SessionEvent randomEvent(std::mt19937& random) {
    const auto number = [&] { return static_cast<std::uint32_t>(random()); };
    const auto yes = [&] { return random() % 2 == 0; };
    switch (random() % 9) {
        case 0:
        case 1: {
            TickEvent event;
            for (auto& part : event.input.position) part = static_cast<std::int64_t>(random() % 400'000) - 200'000;
            for (auto& part : event.input.rotation) part = static_cast<std::int32_t>(random());
            event.input.elapsed = static_cast<std::int32_t>(random() % 4000);
            event.input.pedal = static_cast<std::int32_t>(random() % 65537);
            event.input.cutting = yes(), event.input.hasPose = yes();
            event.taken = number() % 4;
            return event;
        }
        case 2:
            return CarveEvent{number(), yes()};
        case 3:
            return ListEvent{number(), number() % 5, number() % 3, yes()};
        case 4:
            return EditEvent{std::array{Edit::Reset, Edit::Undo, Edit::Redo}[number() % 3], yes()};
        case 7: {
            ExactTickEvent event;
            std::uniform_real_distribution<double> any(-20, 20), time(0, 100);
            for (int axis = 0; axis < 3; ++axis) event.input.deviceInTooth.position[axis] = any(random);
            for (int i = 0; i < 4; ++i) event.input.deviceInTooth.rotation.coeffs()[i] = any(random);
            event.input.pedal = 0.1 * (number() % 10);
            event.input.cutting = yes(), event.swept = yes();
            event.elapsed = time(random), event.time = time(random);
            event.taken = number() % 3;
            return event;
        }
        case 8:
            return FinishEvent{yes(), yes()};
        case 5: {
            ForceEvent event;
            if (yes()) event.parameters.overrides.stiffness = 0.1 * (number() % 50);
            if (yes()) event.parameters.overrides.damping = 1e-4 * (number() % 100);
            if (yes()) event.parameters.overrides.friction = 0.01 * (number() % 100);
            event.parameters.scale = 0.3 * (number() % 10);
            if (yes()) event.parameters.maxStiffness = 0.7 * (1 + number() % 9);
            return event;
        }
        default: {
            const std::uint64_t hash = std::uint64_t{number()} << 32 | number();
            if (yes()) return TickHashEvent{hash};
            return CarvingHashEvent{hash};
        }
    }
}

std::vector<SessionEvent> randomEvents(std::mt19937& random, std::size_t count) {
    std::vector<SessionEvent> events;
    for (std::size_t i = 0; i < count; ++i) events.push_back(randomEvent(random));
    return events;
}

bool isSame(const SessionEvent& a, const SessionEvent& b) {
    if (a.index() != b.index()) return false;
    if (const auto* tick = std::get_if<TickEvent>(&a)) {
        const auto& other = std::get<TickEvent>(b);
        return tick->input == other.input && tick->taken == other.taken;
    }
    if (const auto* force = std::get_if<ForceEvent>(&a)) return force->parameters == std::get<ForceEvent>(b).parameters;
    if (const auto* carve = std::get_if<CarveEvent>(&a)) {
        const auto& other = std::get<CarveEvent>(b);
        return carve->tick == other.tick && carve->published == other.published;
    }
    if (const auto* edit = std::get_if<EditEvent>(&a)) {
        const auto& other = std::get<EditEvent>(b);
        return edit->edit == other.edit && edit->published == other.published;
    }
    if (const auto* list = std::get_if<ListEvent>(&a)) {
        const auto& other = std::get<ListEvent>(b);
        return list->tick == other.tick && list->surface == other.surface && list->recycled == other.recycled &&
               list->sent == other.sent;
    }
    if (const auto* tick = std::get_if<ExactTickEvent>(&a)) {
        const auto& other = std::get<ExactTickEvent>(b);
        const Pose& pose = tick->input.deviceInTooth;
        const Pose& otherPose = other.input.deviceInTooth;
        return pose.position == otherPose.position && pose.rotation.coeffs() == otherPose.rotation.coeffs() &&
               tick->input.pedal == other.input.pedal && tick->input.cutting == other.input.cutting &&
               tick->elapsed == other.elapsed && tick->time == other.time && tick->swept == other.swept &&
               tick->taken == other.taken;
    }
    if (const auto* end = std::get_if<FinishEvent>(&a)) {
        const auto& other = std::get<FinishEvent>(b);
        return end->dropsPieces == other.dropsPieces && end->published == other.published;
    }
    if (const auto* hash = std::get_if<TickHashEvent>(&a)) return hash->hash == std::get<TickHashEvent>(b).hash;
    return std::get<CarvingHashEvent>(a).hash == std::get<CarvingHashEvent>(b).hash;
}

TEST(EventCodec, BringsBackEveryEventInItsPlace) {
    std::mt19937 random(31);
    for (const std::size_t count : {0U, 1U, 2U, 17U, 3000U}) {
        const std::vector<SessionEvent> events = randomEvents(random, count);
        const auto read = decodeEvents(encodeEvents(events));
        ASSERT_TRUE(read);
        ASSERT_EQ(read->size(), events.size());
        for (std::size_t i = 0; i < count; ++i) EXPECT_TRUE(isSame((*read)[i], events[i])) << i;
    }
}

/// A hand that strokes evenly: its second differences are small. docs/session-file.md promises six bytes a tick at
/// most.
TEST(EventCodec, TakesFewBytesForASteadyHand) {
    std::vector<SessionEvent> events;
    for (int i = 0; i < 1000; ++i) {
        const double t = 0.001 * i;
        const Pose hand{Vec3(3 * std::sin(2 * t), 2 * t, -0.2 * t), Quat::Identity()};
        events.emplace_back(TickEvent{TickInput::of({hand, 1, true}, 0.001), 0});
        events.emplace_back(CarveEvent{static_cast<TickNumber>(i + 1), i % 10 == 0});
    }
    EXPECT_LT(encodeEvents(events).size(), 1000U * 30) << "before compression";
}

TEST(EventCodec, RefusesWhatIsCutOffOrLonger) {
    std::mt19937 random(32);
    const std::vector<std::byte> whole = encodeEvents(randomEvents(random, 40));
    for (std::size_t length = 0; length < whole.size(); ++length) {
        EXPECT_FALSE(decodeEvents(std::span(whole).first(length))) << length;
    }
    std::vector<std::byte> longer = whole;
    longer.push_back(std::byte{0});
    EXPECT_FALSE(decodeEvents(longer));
}

TEST(EventCodec, SurvivesAnyBytes) {
    std::mt19937 random(33);
    int refused = 0;
    constexpr int kTries = 20'000;
    const std::vector<std::byte> whole = encodeEvents(randomEvents(random, 12));
    for (int i = 0; i < kTries; ++i) {
        std::vector<std::byte> bytes = whole;
        const std::size_t changes = 1 + random() % 4;
        for (std::size_t j = 0; j < changes; ++j) bytes[random() % bytes.size()] = static_cast<std::byte>(random());
        const auto read = decodeEvents(bytes);
        refused += read ? 0 : 1;
        EXPECT_TRUE(!read || read->size() <= kMaxBlockEvents);
    }
    EXPECT_GT(refused, kTries / 10);
}

TEST(EventCodec, RefusesExactTicksThatAreNotFinite) {
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        for (int i = 0; i < 5; ++i) {
            ExactTickEvent event;
            if (i == 0) event.input.deviceInTooth.position.y() = bad;
            if (i == 1) event.input.deviceInTooth.rotation.z() = bad;
            if (i == 2) event.input.pedal = bad;
            if (i == 3) event.elapsed = bad;
            if (i == 4) event.time = bad;
            EXPECT_FALSE(decodeEvents(encodeEvents(std::vector<SessionEvent>{event}))) << i;
        }
    }
    ExactTickEvent backwards;
    backwards.elapsed = -1;
    EXPECT_FALSE(decodeEvents(encodeEvents(std::vector<SessionEvent>{backwards})));
}

TEST(EventCodec, RefusesForcesBeyondTheLimits) {
    for (const double bad : {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        ForceEvent event;
        event.parameters.overrides.stiffness = bad;
        EXPECT_FALSE(decodeEvents(encodeEvents(std::vector<SessionEvent>{event}))) << bad;
        event.parameters.overrides = {};
        event.parameters.scale = bad;
        EXPECT_FALSE(decodeEvents(encodeEvents(std::vector<SessionEvent>{event}))) << bad;
    }
}

}  // namespace
}  // namespace tactooth
