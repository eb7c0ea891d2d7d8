// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The loop of the hand process, turn by turn, with a clock of the test's own and without a process.
#include "devices/process/hand_servo.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "haptics/force_pipeline.h"
#include "support/heap_counter.h"
#include "support/servo_tick.h"

namespace tactooth {
namespace {

using test::kTick;

/// A device that the test moves, and that remembers the order of its calls.
class TestDevice final : public HapticDevice {
public:
    explicit TestDevice(bool drives) : drives_(drives) { info_.rendersForce = true; }

    [[nodiscard]] const DeviceInfo& info() const override { return info_; }
    [[nodiscard]] Expected<void> open() override { return {}; }
    void close() override {}
    [[nodiscard]] bool drivesServoRate() const override { return drives_; }
    [[nodiscard]] DeviceSample read(double elapsed) override {
        ++reads;
        readTime += elapsed;
        DeviceSample result = sample;
        sample.isFresh = false;
        return result;
    }
    void write(const SafeWrench& wrench) override {
        ++writes;
        force = wrench.force();
    }
    void suspendInput(bool rests) override { suspended = rests; }

    void deliver() {
        sample.isFresh = true;
        sampleListener()();
    }

    DeviceSample sample;
    Vec3 force = Vec3::Zero();
    int reads = 0, writes = 0;
    double readTime = 0;
    bool suspended = false;

private:
    bool drives_;
    DeviceInfo info_;
};

/// The hand process, and the program's end of its link.
class Bench {
public:
    explicit Bench(bool drives) : device(drives), signal(link.handBell) {
        device.setSampleListener(signal.listener());
        servo.emplace(device, link, signal, 1000);
    }
    void send(double newton) {
        ForceMessage message;
        message.sequence = message.endSequence = ++sequence;
        message.answers = poses.value().sequence;
        message.sentAt = now;
        message.force = {0, 0, newton};
        forces.write(message);
    }
    void turn() {
        servo->turn(now);
        hasPose = poses.refresh();
    }
    /// A tick: the device delivers, the program answers 0.2 ms later.
    void tick(double newton) {
        device.deliver();
        turn();
        now += 0.0002;
        send(newton);
        turn();
        now += kTick - 0.0002;
    }
    /// Turns at the times that the loop asks for, until `end`.
    void turnUntil(double end) {
        while (servo->nextTurn() < end) {
            now = std::max(now, servo->nextTurn());
            turn();
        }
        now = end;
    }

    HandLink link;
    TestDevice device;
    SampleSignal signal;
    std::optional<HandServo> servo;
    SlotReader<PoseMessage> poses{link.poses};
    SlotWriter<ForceMessage> forces{link.forces};
    std::uint32_t sequence = 0;
    double now = 100;
    bool hasPose = false;
};

TEST(HandServo, PublishesEachSampleAtOnceAndWakesAProgramWhosePaceTheDeviceSets) {
    Bench bench(true);
    for (int i = 0; i < 100; ++i) {
        bench.device.sample.hand.position = Vec3(0.01 * i, 0, 0);
        bench.device.sample.buttons = static_cast<std::uint32_t>(i);
        bench.device.sample.age = 0.0003;
        const std::uint32_t rings = bench.link.programBell.rings();
        bench.device.deliver();
        bench.turn();
        ASSERT_TRUE(bench.hasPose);
        EXPECT_EQ(bench.link.programBell.rings(), rings + 1);
        const PoseMessage& pose = bench.poses.value();
        EXPECT_EQ(pose.sequence, pose.endSequence);
        EXPECT_NEAR(pose.position[0], 0.01 * i, 1e-12);
        EXPECT_EQ(pose.buttons, static_cast<std::uint32_t>(i));
        EXPECT_EQ(pose.publishedAt, bench.now);
        EXPECT_NEAR(pose.measuredAt, bench.now - 0.0003, 1e-9);
        EXPECT_EQ(pose.freshness, static_cast<std::uint32_t>(i + 1));
        bench.now += kTick;
    }
    EXPECT_EQ(bench.device.reads, 100);
}

TEST(HandServo, GivesAForceToTheDeviceAtOnceAndSaysSo) {
    Bench bench(true);
    for (int i = 0; i < 700; ++i) bench.tick(2);
    EXPECT_NEAR(bench.device.force.z(), 2, 1e-9);
    const PoseMessage& pose = bench.poses.value();
    EXPECT_EQ(pose.applied, bench.sequence);
    EXPECT_EQ(pose.forceDelay, 0);
    EXPECT_EQ(pose.fault, HandFault::None);
}

TEST(HandServo, ReadsADeviceWithoutAThreadOnceForEachForce) {
    Bench bench(false);
    for (int i = 0; i < 500; ++i) {
        bench.send(0);
        bench.turn();
        EXPECT_TRUE(bench.hasPose);
        bench.now += kTick;
    }
    EXPECT_EQ(bench.device.reads, 500);
    EXPECT_EQ(bench.device.writes, 500);
    EXPECT_NEAR(bench.device.readTime, 0.499, 1e-9);
}

TEST(HandServo, WithoutAProgramItKeepsPublishingAndGivesTheDeviceZeros) {
    Bench bench(false);
    bench.turn();
    bench.turnUntil(bench.now + 1);
    EXPECT_GT(bench.device.writes, 600) << "every 1.5 periods";
    EXPECT_LT(bench.device.writes, 700);
    EXPECT_LT(bench.now - bench.poses.value().publishedAt, 0.0016);
    ForceCut cut;
    EXPECT_FALSE(bench.servo->fetchCut(cut)) << "nobody has opened a simulation: no fault";
}

TEST(HandServo, AProgramThatStopsMidPressLeavesNoForceWithinFiveMilliseconds) {
    for (const bool drives : {false, true}) {
        Bench bench(drives);
        for (int i = 0; i < 700; ++i) bench.tick(3);
        bench.turn();
        ASSERT_NEAR(bench.device.force.z(), 3, 1e-9);
        const double lastForce = bench.now - kTick + 0.0002;
        bench.turnUntil(lastForce + 0.00299);
        EXPECT_NEAR(bench.device.force.z(), 3, 1e-9) << "the last force is held";
        bench.turnUntil(lastForce + 0.003 + 0.005);
        EXPECT_TRUE(bench.device.force.isZero(0));
        bench.turnUntil(lastForce + 0.5);
        EXPECT_TRUE(bench.device.force.isZero(0));
        ForceCut cut;
        ASSERT_TRUE(bench.servo->fetchCut(cut));
        EXPECT_EQ(cut.cause, HandFault::NoForce);
        EXPECT_NEAR(cut.at, lastForce + 0.003, 1e-6);
        EXPECT_LE(cut.toZero, 0.003);
        EXPECT_FALSE(bench.servo->fetchCut(cut));
    }
}

TEST(HandServo, ReportsANonsenseForceToTheProgram) {
    Bench bench(true);
    for (int i = 0; i < 700; ++i) bench.tick(3);
    bench.send(std::nan(""));
    bench.turn();
    bench.device.deliver();
    bench.turn();
    EXPECT_EQ(bench.poses.value().fault, HandFault::NotANumber);
    for (int i = 0; i < 10; ++i) bench.tick(0);
    EXPECT_EQ(bench.poses.value().fault, HandFault::None) << "the program has started anew";
}

TEST(HandServo, APoseThatNoHandCanHaveEndsTheForceInTheSameTurn) {
    Bench bench(true);
    for (int i = 0; i < 700; ++i) bench.tick(3);
    bench.device.sample.hand.position.x() = std::nan("");
    bench.device.deliver();
    bench.turn();
    EXPECT_TRUE(bench.device.force.isZero(0));
    for (int i = 0; i < 10; ++i) bench.tick(3);
    EXPECT_TRUE(bench.device.force.isZero(0)) << "whatever the program says";
    bench.device.sample.hand.position.x() = 0;
    for (int i = 0; i < 700; ++i) bench.tick(3);
    bench.device.sample.connected = false;
    bench.device.deliver();
    bench.turn();
    EXPECT_TRUE(bench.device.force.isZero(0)) << "a lost device, too";
}

/// 3 mm in a tick: a hand in free space may move so, one that presses cannot.
TEST(HandServo, AJumpEndsAForceButIsNoFaultWithoutOne) {
    Bench bench(true);
    for (int i = 0; i < 700; ++i) bench.tick(0);
    bench.device.sample.hand.position.x() += 3;
    for (int i = 0; i < 700; ++i) bench.tick(3);
    EXPECT_FALSE(bench.device.force.isZero(0));
    bench.device.sample.hand.position.x() -= 3;
    bench.device.deliver();
    bench.turn();
    EXPECT_TRUE(bench.device.force.isZero(0));
}

TEST(HandServo, ARequestToEndFadesTheForceHoldsZeroAndIsNoFault) {
    Bench bench(true);
    for (int i = 0; i < 700; ++i) bench.tick(3);
    bench.link.endRequested.store(1);
    const double asked = bench.now;
    bench.turn();
    while (!bench.servo->hasEnded()) bench.turnUntil(bench.servo->nextTurn() + 1e-9);
    EXPECT_TRUE(bench.device.force.isZero(0));
    EXPECT_LE(bench.now, asked + 0.010);
    EXPECT_GE(bench.now, asked + 0.005) << "the device has time to take the zero";
    ForceCut cut;
    EXPECT_FALSE(bench.servo->fetchCut(cut));
}

TEST(HandServo, AProgramThatIsGoneIsAFault) {
    Bench bench(true);
    for (int i = 0; i < 700; ++i) bench.tick(3);
    bench.servo->end(HandFault::ProgramEnded);
    bench.turn();
    while (!bench.servo->hasEnded()) bench.turnUntil(bench.servo->nextTurn() + 1e-9);
    ForceCut cut;
    ASSERT_TRUE(bench.servo->fetchCut(cut));
    EXPECT_EQ(cut.cause, HandFault::ProgramEnded);
    EXPECT_NEAR(cut.force, 3, 1e-9);
    EXPECT_LE(cut.toZero, 0.005);
}

TEST(HandServo, HandsOnThatInputIsSuspended) {
    Bench bench(false);
    bench.link.inputSuspended.store(1);
    bench.turn();
    EXPECT_TRUE(bench.device.suspended);
    bench.link.inputSuspended.store(0);
    bench.turn();
    EXPECT_FALSE(bench.device.suspended);
}

TEST(HandServo, ATurnAllocatesNothing) {
    Bench bench(true);
    for (int i = 0; i < 700; ++i) bench.tick(3);
    const long before = test::heapCalls();
    for (int i = 0; i < 100; ++i) bench.tick(3);
    bench.send(std::nan(""));
    bench.turn();
    bench.turnUntil(bench.now + 0.1);
    EXPECT_EQ(test::heapCalls(), before);
}

}  // namespace
}  // namespace tactooth
