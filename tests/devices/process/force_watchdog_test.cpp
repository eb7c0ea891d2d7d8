// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The test has its own clock, so a busy machine has no effect.
#include "devices/process/force_watchdog.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "support/servo_tick.h"

namespace tactooth {
namespace {

using test::kTick;
constexpr double kKnowable = 0.005;  // s from the moment a fault can be known to zero force
const double kNan = std::nan("");
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A watchdog whose program sends forces along z.
class Bench {
public:
    SafeWrench send(double newton) { return send(Vec3(0, 0, newton)); }
    SafeWrench send(const Vec3& force) {
        ForceMessage message;
        message.sequence = message.endSequence = ++sequence;
        message.force = {force.x(), force.y(), force.z()};
        return give(message);
    }
    SafeWrench give(const ForceMessage& message) {
        HandMoment moment;
        moment.now = now;
        moment.published = published;
        return last = watchdog.take(message, moment);
    }
    SafeWrench turn() { return last = watchdog.turn(now); }
    /// Presses with that force until it acts in full.
    void press(double newton) {
        for (int i = 0; i < 600; ++i, now += kTick) (void)send(newton);
        now -= kTick;
        ASSERT_NEAR(last.force().z(), newton, 1e-9);
    }
    /// Turns without forces every `step` s. Returns s until the force is zero.
    double timeToZero(double step = 0.0005) {
        const double start = now;
        for (; !last.force().isZero(0) && now < start + 1; now += step) (void)turn();
        return now - step - start;
    }
    /// The program starts anew: a zero, and then the force.
    void startAnew(double newton) {
        for (int i = 0; i < 5; ++i) now += kTick, (void)send(0);
        press(newton);
    }

    ForceWatchdog watchdog{ForceLimits()};
    double now = 100;
    std::uint32_t sequence = 0;
    std::uint32_t published = 0;
    SafeWrench last;
};

TEST(ForceWatchdog, PassesForcesAsTheLimiterDoes) {
    Bench bench;
    SafetyLimiter limiter{ForceLimits()};
    std::mt19937 random(20261127);
    std::uniform_real_distribution<double> newton(-1.5, 1.5);
    Vec3 force = Vec3::Zero();
    for (int i = 0; i < 5000; ++i, bench.now += kTick) {
        force = 0.95 * force + 0.05 * Vec3(newton(random), newton(random), newton(random));
        // The first message has no time since the last one: the limiter starts from zero.
        const SafeWrench expected = limiter.limit({force, Vec3::Zero()}, i == 0 ? 100 : kTick, true, 0);
        EXPECT_TRUE(bench.send(force).force().isApprox(expected.force(), 1e-6) || expected.force().isZero(1e-9)) << i;
    }
    EXPECT_EQ(bench.watchdog.fault(), HandFault::None);
    EXPECT_FALSE(bench.watchdog.fetchCut());
}

TEST(ForceWatchdog, WithoutAFreshForceForThreeMillisecondsItFadesToZeroWithinFive) {
    Bench bench;
    bench.press(3);
    const double lastForce = bench.now;
    bench.now = lastForce + 0.0029;
    EXPECT_NEAR(bench.turn().force().z(), 3, 1e-9) << "not yet";
    bench.now = lastForce + 0.003;
    (void)bench.turn();
    EXPECT_TRUE(bench.watchdog.isFading());
    double before = bench.last.force().z();
    for (int i = 0; i < 3; ++i) {
        bench.now += 0.0005;
        EXPECT_LT(bench.turn().force().z(), before);
        EXPECT_GT(bench.last.force().z(), 0) << "it fades and does not jump";
        before = bench.last.force().z();
    }
    EXPECT_LE(bench.now + bench.timeToZero() - (lastForce + 0.003), kKnowable);
    const auto cut = bench.watchdog.fetchCut();
    ASSERT_TRUE(cut);
    EXPECT_EQ(cut->cause, HandFault::NoForce);
    EXPECT_NEAR(cut->at, lastForce + 0.003, 1e-9);
    EXPECT_NEAR(cut->force, 3, 1e-9);
    EXPECT_NEAR(cut->toZero, ForceWatchdog::kFadeTime, 0.0005 + 1e-9);
    EXPECT_FALSE(bench.watchdog.fetchCut()) << "once";
    for (int i = 0; i < 1000; ++i) {
        bench.now += kTick;
        EXPECT_TRUE(bench.turn().force().isZero(0));
    }
    EXPECT_EQ(bench.watchdog.fault(), HandFault::None) << "the program itself knows when it was late";
}

TEST(ForceWatchdog, ALateTurnFindsTheFaultAsWell) {
    Bench bench;
    bench.press(3);
    bench.now += 0.050;  // this process was late itself
    (void)bench.turn();
    EXPECT_LE(bench.timeToZero(), kKnowable);
    const auto cut = bench.watchdog.fetchCut();
    ASSERT_TRUE(cut);
    EXPECT_GT(cut->toZero, 0.04) << "the log states the true time";
}

TEST(ForceWatchdog, AForceAfterASilenceDoesNotPassBeforeTheProgramHasSentAZero) {
    Bench bench;
    bench.press(3);
    bench.now += 0.010;
    for (int i = 0; i < 100; ++i, bench.now += kTick) (void)bench.send(3);
    EXPECT_TRUE(bench.last.force().isZero(0));
    EXPECT_EQ(bench.watchdog.fault(), HandFault::NoForce) << "the program has not noticed: it is notified";
    bench.startAnew(3);
    EXPECT_EQ(bench.watchdog.fault(), HandFault::None);
}

TEST(ForceWatchdog, AProgramThatStartsAnewByItselfIsNotNotified) {
    Bench bench;
    bench.press(3);
    bench.now += 0.010;
    (void)bench.send(0);  // its own limiter has seen that it was late
    for (int i = 0; i < 100; ++i, bench.now += kTick) {
        (void)bench.send(3);
        EXPECT_EQ(bench.watchdog.fault(), HandFault::None);
        const bool isFading = i * kTick < ForceWatchdog::kFadeTime;
        const double ramp = 3.0 * (i + 1) * kTick / ForceLimits().rampTime;
        EXPECT_LE(bench.last.force().z(), (isFading ? 3 : ramp) + 1e-9) << i;
    }
    EXPECT_GT(bench.last.force().z(), 0);
}

TEST(ForceWatchdog, ASilenceWithoutAForceIsNoFault) {
    Bench bench;
    bench.press(0);
    bench.now += 10;  // no simulation runs
    EXPECT_TRUE(bench.turn().force().isZero(0));
    EXPECT_EQ(bench.watchdog.fault(), HandFault::None);
    EXPECT_FALSE(bench.watchdog.fetchCut());
    EXPECT_EQ(bench.watchdog.silentFrom(), kInfinity);
    bench.press(2);
}

struct Nonsense {
    const char* name;
    HandFault fault;
    void (*make)(ForceMessage& message);
};

class ForceWatchdogNonsense : public ::testing::TestWithParam<Nonsense> {};

TEST_P(ForceWatchdogNonsense, FadesToZeroHoldsItAndIsReported) {
    Bench bench;
    bench.published = 1000;
    bench.press(3);
    bench.now += kTick;
    const double fault = bench.now;
    for (int i = 0; i < 20; ++i, bench.now += 0.0005) {  // again and again: it is one fault
        ForceMessage message;
        message.sequence = message.endSequence = ++bench.sequence;
        message.force = {0, 0, 3};
        GetParam().make(message);
        (void)bench.give(message);
        if (bench.now >= fault + kKnowable) {
            EXPECT_TRUE(bench.last.force().isZero(0));
        }
    }
    EXPECT_TRUE(bench.last.force().isZero(0));
    EXPECT_EQ(bench.watchdog.fault(), GetParam().fault);
    const auto cut = bench.watchdog.fetchCut();
    ASSERT_TRUE(cut);
    EXPECT_EQ(cut->cause, GetParam().fault);
    EXPECT_NEAR(cut->at, fault, 1e-9);
    EXPECT_LE(cut->toZero, kKnowable);
    for (int i = 0; i < 100; ++i) bench.now += kTick, (void)bench.send(3);
    EXPECT_TRUE(bench.last.force().isZero(0)) << "a valid force does not pass either";
    EXPECT_FALSE(bench.watchdog.fetchCut()) << "it was one fault";
    bench.startAnew(3);
    EXPECT_EQ(bench.watchdog.fault(), HandFault::None);
}

INSTANTIATE_TEST_SUITE_P(
    All, ForceWatchdogNonsense,
    ::testing::Values(
        Nonsense{"NotANumber", HandFault::NotANumber, [](ForceMessage& m) { m.force[1] = kNan; }},
        Nonsense{"Infinite", HandFault::NotANumber, [](ForceMessage& m) { m.force[0] = kInfinity; }},
        Nonsense{"TorqueNotANumber", HandFault::NotANumber, [](ForceMessage& m) { m.torque[2] = kNan; }},
        Nonsense{"TooStrong", HandFault::BeyondLimits, [](ForceMessage& m) { m.force[2] = 3.31; }},
        Nonsense{"Huge", HandFault::BeyondLimits, [](ForceMessage& m) { m.force[2] = -1e300; }},
        Nonsense{"Torque", HandFault::BeyondLimits, [](ForceMessage& m) { m.torque[0] = 0.001; }},
        Nonsense{"HalfWritten", HandFault::WrongSequence, [](ForceMessage& m) { --m.endSequence; }},
        Nonsense{"Repeated", HandFault::WrongSequence, [](ForceMessage& m) { m.sequence = m.endSequence = 600; }},
        Nonsense{"Older", HandFault::WrongSequence,
                 [](ForceMessage& m) { m.sequence = m.endSequence = 599 - m.sequence % 7 * 2; }},
        Nonsense{"FarAhead", HandFault::WrongSequence,
                 [](ForceMessage& m) { m.sequence = m.endSequence = 5000 * m.sequence; }},
        Nonsense{"AnswersTheFuture", HandFault::WrongSequence, [](ForceMessage& m) { m.answers = 1001; }}),
    [](const auto& one) { return one.param.name; });

TEST(ForceWatchdog, TheSequenceGoesOnAfterItsLastNumber) {
    Bench bench;
    bench.sequence = std::numeric_limits<std::uint32_t>::max() - 300;
    bench.published = 5;
    bench.press(3);
    EXPECT_LT(bench.sequence, 1000U) << "it has wrapped around";
    EXPECT_EQ(bench.watchdog.fault(), HandFault::None);
    EXPECT_FALSE(bench.watchdog.fetchCut());
}

TEST(ForceWatchdog, SomeForcesMayBeMissed) {
    Bench bench;
    for (int i = 0; i < 600; ++i, bench.now += kTick) bench.sequence += 3, (void)bench.send(3);
    EXPECT_NEAR(bench.last.force().z(), 3, 1e-9);
    EXPECT_EQ(bench.watchdog.fault(), HandFault::None);
}

TEST(ForceWatchdog, TheSecondLimiterBoundsTheRateAndThePower) {
    Bench bench;
    bench.press(0);
    for (int i = 0; i < 600; ++i) bench.now += kTick, (void)bench.send(0);
    bench.now += kTick;
    EXPECT_LE(bench.send(3.3).force().z(), 0.3 + 1e-9) << "a program without a limiter cannot kick";
    ForceMessage message;
    message.sequence = message.endSequence = ++bench.sequence;
    message.force = {0, 0, 3};
    bench.now += kTick;
    HandMoment moment{bench.now, 1e5, true, 0};
    EXPECT_LE(bench.watchdog.take(message, moment).force().z() * 1e5, ForceLimits().power * (1 + 1e-9));
}

TEST(ForceWatchdog, APoseThatIsNotValidEndsTheForceAtOnce) {
    Bench bench;
    bench.press(3);
    EXPECT_TRUE(bench.watchdog.stop().force().isZero(0));
    EXPECT_TRUE(bench.watchdog.isSilent());
    bench.now += kTick;
    ForceMessage message;
    message.sequence = message.endSequence = ++bench.sequence;
    message.force = {0, 0, 3};
    EXPECT_TRUE(bench.watchdog.take(message, {bench.now, 0, false, 0}).force().isZero(0));
    EXPECT_FALSE(bench.watchdog.fetchCut()) << "the program reports the pose";
}

TEST(ForceWatchdog, TheEndFadesTheForceForGood) {
    for (const HandFault cause : {HandFault::None, HandFault::ProgramEnded}) {
        Bench bench;
        bench.press(3);
        bench.watchdog.end(cause, bench.now);
        EXPECT_LE(bench.timeToZero(), kKnowable);
        const auto cut = bench.watchdog.fetchCut();
        EXPECT_EQ(cut.has_value(), cause != HandFault::None) << "an end that the program asks for is no fault";
        for (int i = 0; i < 100; ++i) {
            bench.now += kTick;
            EXPECT_TRUE(bench.send(i < 10 ? 0 : 3).force().isZero(0));
        }
    }
}

TEST(ForceWatchdog, TheEndOfAProgramThatWasSilentBeforeIsTheCause) {
    Bench bench;
    bench.press(3);
    bench.now += 0.0031;
    (void)bench.turn();
    bench.watchdog.end(HandFault::ProgramEnded, bench.now + 0.0002);
    EXPECT_LE(bench.timeToZero(), kKnowable);
    auto cut = bench.watchdog.fetchCut();
    ASSERT_TRUE(cut);
    EXPECT_EQ(cut->cause, HandFault::ProgramEnded);
    EXPECT_NEAR(cut->force, 3, 1e-9);
    EXPECT_FALSE(cut->isAfterCut);

    Bench later;
    later.press(3);
    later.now += 0.0031;
    (void)later.turn();
    (void)later.timeToZero();
    EXPECT_EQ(later.watchdog.fetchCut()->cause, HandFault::NoForce);
    later.now += 1;
    later.watchdog.end(HandFault::ProgramEnded, later.now);
    (void)later.turn();
    cut = later.watchdog.fetchCut();
    ASSERT_TRUE(cut);
    EXPECT_EQ(cut->cause, HandFault::ProgramEnded);
    EXPECT_EQ(cut->force, 0);
    EXPECT_TRUE(cut->isAfterCut);
}

/// Messages of a program that has lost its mind, at arbitrary moments: no force is beyond the limits, rises faster than
/// the slew rate, or is left 5 ms after the last valid message.
TEST(ForceWatchdog, NoMixtureOfMessagesMakesAForceThatIsLateTooStrongOrNoNumber) {
    Bench bench;
    std::mt19937 random(20261128);
    const ForceLimits limits;
    double lastValid = bench.now;
    for (int i = 0; i < 300'000; ++i) {
        const double before = bench.last.force().norm();
        const double step = random() % 50 == 0 ? 0.004 : 0.0002 * (1 + random() % 5);
        bench.now += step;
        const unsigned kind = random() % 40;
        if (kind < 30) {
            (void)bench.send(i % 3000 < 30 ? 0 : 3.2);
            if (bench.watchdog.fault() == HandFault::None) lastValid = bench.now;
        } else if (kind < 36) {
            (void)bench.turn();
        } else {
            ForceMessage message;
            const auto word = [&random] { return random(); };
            auto* const words = reinterpret_cast<std::uint32_t*>(&message);
            if (kind < 38) {
                std::generate_n(words, sizeof message / sizeof *words, word);
            } else {
                message.sequence = message.endSequence = ++bench.sequence;
                message.force[random() % 3] = kind == 38 ? kNan : 50;
            }
            (void)bench.give(message);
        }
        const double force = bench.last.force().norm();
        ASSERT_TRUE(std::isfinite(force)) << i;
        ASSERT_LE(force, limits.force * (1 + 1e-9)) << i;
        ASSERT_LE(force - before, limits.slew * 0.0045 + 1e-9) << i;
        if (bench.now > lastValid + 0.003 + kKnowable) {
            ASSERT_EQ(force, 0) << i;
        }
    }
}

}  // namespace
}  // namespace tactooth
