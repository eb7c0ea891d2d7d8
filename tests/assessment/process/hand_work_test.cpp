// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/process/hand_work.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace tactooth {
namespace {

/// What a tick of a session may be.
struct Hand {
    Vec3 place = Vec3::Zero();
    double force = 0;
    bool touches = false, turns = false, placed = true;
};

TrackTick tickOf(double time, const Hand& hand) {
    TrackTick tick;
    tick.time = time;
    for (std::size_t i = 0; i < 3; ++i) tick.position[i] = hand.place[static_cast<Eigen::Index>(i)];
    tick.force = {0, hand.force * 0.6, hand.force * 0.8};
    tick.contacts = hand.touches ? 1 : 0;
    tick.speedRpm = hand.turns ? 200'000 : 0;
    tick.placed = hand.placed;
    return tick;
}

HandWork workOf(double seconds, const std::function<Hand(double)>& hand, double rate = 1000) {
    HandWorkMeter meter;
    const auto ticks = static_cast<int>(std::lround(seconds * rate));
    for (int i = 0; i <= ticks; ++i) meter.add(tickOf(i / rate, hand(i / rate)));
    return meter.finish().value();
}

TEST(HandWork, OfASessionWithoutATouchIsNotMeasurable) {
    EXPECT_FALSE(HandWorkMeter().finish());
    HandWorkMeter meter;
    for (int i = 0; i < 1000; ++i) meter.add(tickOf(i / 1000.0, {.turns = true}));
    EXPECT_FALSE(meter.finish());
}

TEST(HandWork, WithoutAStrokeHasNoSmoothness) {
    const HandWork work = workOf(1, [](double) { return Hand{.force = 1, .touches = true}; });
    EXPECT_EQ(work.strokes, 0);
    for (const Measured& each : {work.strokeTime, work.arcLength, work.jerk, work.frequency95, work.forceSpread}) {
        EXPECT_FALSE(each.value);
        EXPECT_NE(each.reason, nullptr);
    }
    EXPECT_NEAR(work.forceMean, 1, 1e-9);
}

TEST(HandWork, DividesTheTimeByTurningAndTouching) {
    // 1 s drilling, 2 s spinning, 3 s pause, 0.5 s pause between two touches without turning
    const HandWork work = workOf(7, [](double t) {
        if (t < 1) return Hand{.touches = true, .turns = true};
        if (t < 3) return Hand{.turns = true};
        if (t < 6) return Hand{};
        if (t < 6.25 || t >= 6.75) return Hand{.touches = true};
        return Hand{};
    });
    EXPECT_NEAR(work.seconds, 7, 1e-9);
    EXPECT_NEAR(work.drilling, 1, 0.002);
    EXPECT_NEAR(work.idle, 2, 0.002);
    EXPECT_NEAR(work.dead, 3, 0.002);
}

TEST(HandWork, TheRootMeanSquareOfAForceThatSwingsIsItsClosedForm) {
    // 1 N with a swing of 0.5 N: the squares have a mean of 1 + 0.25 / 2.
    const HandWork work = workOf(4, [](double t) {
        return Hand{.force = 1 + 0.5 * std::sin(2 * std::numbers::pi * t), .touches = true, .turns = true};
    });
    EXPECT_NEAR(work.forceMean, 1, 1e-3);
    EXPECT_NEAR(work.forceRms, std::sqrt(1 + 0.125), 1e-3);
}

TEST(HandWork, TheTiltIsThatOfTheShaftWhileItDrills) {
    const Vec3 axis = Vec3(1, 2, 3).normalized();
    HandWorkMeter meter(axis);
    const double first = 0.1, second = 0.4;  // rad, for 1 s and for 3 s; then 2 s in the air, level
    for (int i = 0; i <= 6000; ++i) {
        const double time = i / 1000.0;
        TrackTick tick = tickOf(time, {.touches = time < 4, .turns = true});
        const double tilt = time < 1 ? first : time < 4 ? second : std::numbers::pi / 2;
        const Quat upright = Quat::FromTwoVectors(Vec3::UnitZ(), axis);
        const Quat turn = Quat(Eigen::AngleAxisd(tilt, axis.unitOrthogonal())) * upright;
        tick.rotation = {turn.x(), turn.y(), turn.z(), turn.w()};
        meter.add(tick);
    }
    const HandWork work = meter.finish().value();
    EXPECT_NEAR(work.burTilt.value.value_or(-1), (first + 3 * second) / 4 * 180 / std::numbers::pi, 0.02);
    EXPECT_FALSE(workOf(1, [](double) { return Hand{.touches = true}; }).burTilt.value) << "nothing was drilled";
}

TEST(HandWork, ThePathOfACircleIsItsLengthAtEachRate) {
    for (const double rate : {500.0, 1000.0, 4000.0}) {
        const HandWork work = workOf(
            4,
            [](double t) {
                const double angle = 2 * std::numbers::pi * t / 4;
                return Hand{.place = 3 * Vec3(std::cos(angle), std::sin(angle), 0), .touches = true};
            },
            rate);
        EXPECT_NEAR(work.path, 2 * std::numbers::pi * 3, 0.02) << rate;
    }
}

TEST(HandWork, NoiseOfASensorMakesNoPath) {
    const HandWork work = workOf(4, [](double t) {
        const double noise = 0.005 * std::sin(2 * std::numbers::pi * 333 * t);
        return Hand{.place = Vec3(2 * t, noise, 0), .touches = true};
    });
    EXPECT_NEAR(work.path, 8, 0.02);
}

TEST(HandWork, AnotherBurOrALostHandMakesNoPath) {
    HandWorkMeter meter;
    for (int i = 0; i < 1000; ++i) meter.add(tickOf(i / 1000.0, {.touches = true}));
    meter.interrupt();
    for (int i = 1000; i < 2000; ++i) meter.add(tickOf(i / 1000.0, {.place = Vec3(50, 0, 0)}));
    for (int i = 2000; i < 2010; ++i) meter.add(tickOf(i / 1000.0, {.placed = false}));
    for (int i = 2010; i < 3000; ++i) meter.add(tickOf(i / 1000.0, {.place = Vec3(0, 70, 0)}));
    EXPECT_NEAR(meter.finish().value().path, 0, 1e-6);
}

TEST(HandWork, CountsContactsWithoutShortOnesAndShortGaps) {
    // Contacts of 0.4, 0.03 (too short), 0.2 + 0.02 gap + 0.2 (one), and 0.4 s with the bur at rest (none).
    const HandWork work = workOf(4, [](double t) {
        const auto within = [t](double begin, double end) { return t >= begin && t < end; };
        const bool turns = t < 3;
        return Hand{.touches = within(0.5, 0.9) || within(1.2, 1.23) || within(1.5, 1.7) || within(1.72, 1.92) ||
                               within(3.2, 3.6),
                    .turns = turns};
    });
    EXPECT_EQ(work.strokes, 2);
    EXPECT_NEAR(*work.strokeTime.value, (0.4 + 0.42) / 2, 0.003);
}

TEST(HandWork, ForcesAreThoseOfTheContacts) {
    // 0.5 N for 2 s, 3 N for 0.5 s; 9 N in the air do not count
    const HandWork work = workOf(5, [](double t) {
        if (t < 2) return Hand{.force = 0.5, .touches = true, .turns = true};
        if (t < 3) return Hand{.force = 9};
        if (t < 3.5) return Hand{.force = 3, .touches = true, .turns = true};
        return Hand{};
    });
    EXPECT_NEAR(work.forceMean, (2 * 0.5 + 0.5 * 3) / 2.5, 0.01);
    EXPECT_NEAR(work.forcePeak, 3, 1e-9);
    EXPECT_NEAR(work.forceP95, 3, 1e-9);  // a fifth of the time
    EXPECT_NEAR(work.forceOver2, 0.2, 0.002);
    EXPECT_NEAR(work.impulse, 2.5, 0.01);
    EXPECT_NEAR(*work.forceSpread.value, 0, 1e-6);  // steady within each stroke
}

TEST(HandWork, AnUnsteadyForceHasItsStandardDeviation) {
    const HandWork work = workOf(2, [](double t) {
        return Hand{.force = 1 + 0.3 * std::sin(2 * std::numbers::pi * 5 * t), .touches = true, .turns = true};
    });
    EXPECT_NEAR(*work.forceSpread.value, 0.3 / std::numbers::sqrt2, 0.002);
    EXPECT_NEAR(work.forceP95, 1 + 0.3 * std::sin(std::numbers::pi * 0.45), 0.005);
}

/// Two strokes of a second: 3 mm straight, and half a circle of 2 mm; between them the bur wanders in the air.
TEST(HandWork, TheEconomyOfAStraightStrokeAndHalfACircleIsItsClosedForm) {
    const double pi = std::numbers::pi;
    for (const double rate : {500.0, 1000.0, 2000.0}) {
        const HandWork work = workOf(
            4,
            [pi](double t) {
                if (t < 1) return Hand{.place = Vec3(3 * t, 0, 0), .touches = true, .turns = true};
                if (t < 2) return Hand{.place = Vec3(3, 4 * std::sin(pi * (t - 1)), 0), .turns = true};
                const double angle = pi * std::clamp(t - 2, 0.0, 1.0);
                return Hand{
                    .place = Vec3(1 + 2 * std::cos(angle), 2 * std::sin(angle), 0), .touches = t < 3, .turns = true};
            },
            rate);
        EXPECT_EQ(work.strokes, 2);
        EXPECT_NEAR(work.economy.value.value_or(-1), (3 + 4) / (3 + 2 * pi), 0.01) << rate;
    }
}

TEST(HandWork, TheEconomyOfAStraightStrokeIsOneAndOfAReturnItIsNearNothing) {
    const HandWork straight =
        workOf(1, [](double t) { return Hand{.place = Vec3(t, 2 * t, 0), .touches = true, .turns = true}; });
    EXPECT_NEAR(straight.economy.value.value_or(-1), 1, 1e-6);
    const HandWork back = workOf(2, [](double t) {
        return Hand{.place = Vec3(2 * std::sin(std::numbers::pi * t / 2), 0, 0), .touches = true, .turns = true};
    });
    EXPECT_NEAR(back.economy.value.value_or(-1), 0, 0.01);
}

/// A hundred touches that only tremble: a median over the strokes would be theirs.
TEST(HandWork, TouchesThatHardlyMoveDoNotChangeTheEconomy) {
    const HandWork work = workOf(24, [](double t) {
        if (t < 2) return Hand{.place = Vec3(3 * t, 0, 0), .touches = true, .turns = true};
        const double phase = std::fmod(t, 0.2);
        const double tremor = 0.001 * std::sin(2 * std::numbers::pi * 15 * t);
        return Hand{.place = Vec3(6, tremor, 0), .touches = phase < 0.1, .turns = true};
    });
    EXPECT_GT(work.strokes, 100);
    EXPECT_NEAR(work.economy.value.value_or(-1), 1, 0.1);
}

TEST(HandWork, WithoutMovementThereIsNoEconomy) {
    const HandWork still = workOf(1, [](double) { return Hand{.touches = true, .turns = true}; });
    EXPECT_FALSE(still.economy.value);
    EXPECT_EQ(still.economy.reason->id, "strokes_without_path");
    const HandWork none = workOf(1, [](double t) { return Hand{.place = Vec3(t, 0, 0), .touches = true}; });
    EXPECT_FALSE(none.economy.value);
    EXPECT_EQ(none.economy.reason->id, "no_stroke");
}

TEST(HandWork, ATremblingStrokeIsLessSmooth) {
    const auto stroke = [](double tremor) {
        return workOf(2, [tremor](double t) {
            const double along = 2 * (1 - std::cos(std::numbers::pi * t / 2));
            const double aside = tremor * std::sin(2 * std::numbers::pi * 6 * t);
            return Hand{.place = Vec3(along, aside, 0), .touches = true, .turns = true};
        });
    };
    const HandWork steady = stroke(0), trembling = stroke(0.1);
    EXPECT_EQ(steady.strokes, 1);
    EXPECT_LT(*trembling.arcLength.value, *steady.arcLength.value - 0.1);
    EXPECT_LT(*trembling.jerk.value, *steady.jerk.value - 1);
    EXPECT_GT(*trembling.frequency95.value, *steady.frequency95.value + 2);
    EXPECT_GT(trembling.path, steady.path + 1);
}

}  // namespace
}  // namespace tactooth
