// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Two devices of two backends, tested up to the connections of the stand-ins.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <thread>

#include "devices/haply/haply_device.h"
#include "devices/openhaptics/openhaptics_device.h"
#include "devices/standin/plane_servo.h"
#include "devices/standin/standin_haply.h"
#include "devices/standin/standin_hd.h"
#include "haptics/servo_loop.h"
#include "session/control/device_set.h"

namespace tactooth {
namespace {

using namespace std::chrono_literals;
using test::kWall;
using test::soon;
using test::soonSaysNothing;
using test::StandinHaply;

constexpr double kContactForce = 0.3;  // N

const test::HdStandinControl& standin() {
    static const auto* const control = static_cast<const test::HdStandinControl*>(
        dlsym(dlopen(TACTOOTH_STANDIN_HD, RTLD_LAZY | RTLD_GLOBAL), "standinControl"));
    return *control;
}

/// The result of a tick on a plane.
Tick tickOnPlane(const Pose& tool) {
    Tick tick;
    tick.contact.placed = tool.position.allFinite();
    tick.contact.depth = std::max(0.0, kWall - tool.position.z());
    tick.force.deflection = tick.contact.depth;
    tick.contact.triangles = tick.contact.depth > 0 ? 1 : 0;
    tick.force.stiffness = tick.contact.depth > 0 ? test::kWallStiffness : 0;
    if (tick.contact.placed) tick.force.wrench.force = Vec3(0, 0, test::kWallStiffness * tick.contact.depth);
    return tick;
}

/// A servo loop for two devices over the plane.
class DeviceSetServo {
public:
    DeviceSetServo(HapticDevice& first, HapticDevice& second)
        : hands_(first, &second, {}),
          loop_(
              1000, [this](double elapsed) { tick(elapsed); },
              [&first](double longest) { first.waitForTick(longest); }) {}

    [[nodiscard]] long ticks() const { return static_cast<long>(loop_.timing().ticks.load()); }

private:
    void tick(double elapsed) {
        hands_.read(elapsed, {});
        hands_.write(tickOnPlane(hands_.turbine()), true, elapsed);
    }
    DeviceSet hands_;
    ServoLoop loop_;
};

class TwoDevices : public ::testing::Test {
protected:
    void SetUp() override { standin().reset(); }
    void TearDown() override { standin().reset(); }

    /// Waits for so many more ticks of the driver of the pens.
    static bool pass(long ticks) {
        const long before = standin().ticks();
        return soon([before, ticks] { return standin().ticks() > before + ticks; }, 10s);
    }
    /// Until the servo has seen what the stand-in shows now.
    static void waitUntilRead(const DeviceSetServo& servo) {
        constexpr long kOnTheWay = 150;  // ticks: a stall of the machine hides the buttons for 100 of them
        EXPECT_TRUE(pass(kOnTheWay));
        const long before = servo.ticks();
        EXPECT_TRUE(soon([&] { return servo.ticks() > before + kOnTheWay; }));
    }
    static void swapByButton(const DeviceSetServo& servo) {
        for (const int buttons : {0, 1, 0}) {
            standin().setButtons(buttons);
            waitUntilRead(servo);
        }
    }
    /// Presses all pens down together until one of them renders a force. A busy machine only slows it.
    static bool leanPens(int pen) {
        return soon([pen] {
            standin().wantPosition(0, 5, 0);
            if (!pass(200)) return false;
            standin().wantPosition(0, kWall - 4, 0);
            return pass(500) && standin().forceOf(pen) > kContactForce;
        });
    }
};

/// A pen that holds the turbine, and an Inverse3 that holds the mirror.
struct PenAndArm {
    void open() {
        ASSERT_TRUE(pen.open());
        ASSERT_TRUE(arm.open());
        servo.emplace(pen, arm);
    }

    StandinHaply service;
    OpenHapticsDevice pen{"", TACTOOTH_STANDIN_HD};
    HaplyDevice arm{"", service.address()};
    std::optional<DeviceSetServo> servo;
};

TEST_F(TwoDevices, TwoPensExchangeTurbineAndMirror) {
    OpenHapticsDevice right("Right", TACTOOTH_STANDIN_HD);
    OpenHapticsDevice left("Left", TACTOOTH_STANDIN_HD);
    ASSERT_TRUE(right.open());
    ASSERT_TRUE(left.open());
    const DeviceSetServo servo(right, left);
    ASSERT_TRUE(leanPens(0));
    EXPECT_EQ(standin().forceOf(1), 0) << "a mirror touches nothing";
    swapByButton(servo);
    EXPECT_TRUE(soon([] { return standin().forceOf(0) == 0; }));
    EXPECT_EQ(standin().forceOf(1), 0) << "it took over a bur that is deep in the plane";
    ASSERT_TRUE(leanPens(1));
    EXPECT_EQ(standin().forceOf(0), 0);
}

TEST_F(TwoDevices, APenAndAnInverse3ExchangeTurbineAndMirror) {
    PenAndArm both;
    ASSERT_NO_FATAL_FAILURE(both.open());
    ASSERT_TRUE(leanPens(0));
    EXPECT_EQ(both.service.force(), 0);
    swapByButton(*both.servo);
    EXPECT_TRUE(soon([] { return standin().forceOf(0) == 0; }));
    EXPECT_EQ(both.service.force(), 0);
    EXPECT_TRUE(soon([&] {  // the arm took over deep below the plane: it lifts off and comes down again
        const auto passes = [&](long messages) {
            const long before = both.service.messages();
            return soon([&] { return both.service.messages() > before + messages; }, 10s);
        };
        both.service.wantPosition(0, 0, 0.012);
        if (!passes(200)) return false;
        both.service.wantPosition(0, 0, 0);
        return passes(500) && both.service.force() > kContactForce;
    }));
    EXPECT_EQ(standin().forceOf(0), 0);
}

TEST_F(TwoDevices, AnInverse3ThatIsLostLeavesThePenAlone) {
    PenAndArm both;
    ASSERT_NO_FATAL_FAILURE(both.open());
    ASSERT_TRUE(leanPens(0));
    both.service.setFault(test::HaplyFault::Drop);
    ASSERT_TRUE(test::soonSays(both.arm, "has closed the connection"));
    std::this_thread::sleep_for(1500ms);
    EXPECT_TRUE(leanPens(0));
    EXPECT_NE(both.arm.faultMessage(), nullptr);
    EXPECT_TRUE(soonSaysNothing(both.pen));
}

}  // namespace
}  // namespace tactooth
