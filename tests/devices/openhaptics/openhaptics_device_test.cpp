// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/openhaptics/openhaptics_device.h"

#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "devices/base/monotonic_clock.h"
#include "devices/openhaptics/hd_library.h"
#include "standin/pen_folder.h"
#include "standin/plane_servo.h"
#include "standin/standin_hd.h"

namespace tactooth {
namespace {

using namespace std::chrono_literals;
using test::HdFault;
using test::kWall;
using test::PenFolder;
using test::soon;
using test::soonSays;
using test::soonSaysNothing;
using Servo = test::PlaneServo;
using ::testing::HasSubstr;

const test::HdStandinControl& standin() {
    static const auto* const control = static_cast<const test::HdStandinControl*>(
        dlsym(dlopen(TACTOOTH_STANDIN_HD, RTLD_LAZY | RTLD_GLOBAL), "standinControl"));
    return *control;
}

constexpr long kBadReading = 1;  // the first tick after a fault was set
constexpr double kLoss = 0.005;  // s after which a lost device renders no force

class OpenHaptics : public ::testing::Test {
protected:
    void SetUp() override { standin().reset(); }
    void TearDown() override { standin().reset(); }

    static double force() {
        double xyz[3];
        standin().lastForce(xyz);
        return std::hypot(xyz[0], xyz[1], xyz[2]);
    }
    static void set(HdFault fault) { standin().setFault(static_cast<int>(fault)); }
    static std::string openError(const std::string& name = {}, const std::string& library = TACTOOTH_STANDIN_HD) {
        OpenHapticsDevice device(name, library);
        const auto opened = device.open();
        return opened ? "" : opened.error().message();
    }
    /// Waits for so many more ticks of the driver: the hand moves by a millisecond with each of them.
    static bool pass(long ticks) {
        const long before = standin().ticks();
        return soon([before, ticks] { return standin().ticks() > before + ticks; }, 10s);
    }
    /// Lifts off and presses on the plane, repeatedly until a force acts; down is -y in HDAPI's frame. A busy machine
    /// only slows it: it counts in ticks.
    static bool lean() {
        return soon([] {
            standin().wantPosition(0, 5, 0);
            if (!pass(300)) return false;
            standin().wantPosition(0, kWall - 4, 0);
            return pass(700) && force() > 0.3;
        });
    }
    /// Leans, and then presses deeper until the condition holds: after a stall of the machine it leans again.
    template <class Condition>
    static bool pressUntil(const Condition& condition) {
        return soon([&condition] {
            const bool leans = lean();
            standin().wantPosition(0, kWall - 9, 0);
            return leans && soon(condition, 2s);
        });
    }

private:
    PenFolder noPens_{{}};  // hides the pens that are configured on this machine
};

TEST_F(OpenHaptics, DescribesTheDevice) {
    OpenHapticsDevice device("", TACTOOTH_STANDIN_HD);
    ASSERT_TRUE(device.open());
    EXPECT_EQ(device.info().name, "Touch (stand-in)");
    EXPECT_EQ(device.info().limits.force, 3.3);
    EXPECT_EQ(device.info().limits.continuousForce, 0.88);
    EXPECT_EQ(device.info().workspace, Vec3(160, 70, 120));
    EXPECT_EQ(device.info().workspaceCentre, Vec3(0, -5, 5));
    EXPECT_EQ(device.info().stiffness, 0.5);
    EXPECT_TRUE(device.drivesServoRate());
    EXPECT_EQ(standin().startedPens(), 1);
    device.close();
    EXPECT_EQ(standin().startedPens(), 0);
}

TEST_F(OpenHaptics, TouchesAPlaneAndStops) {
    {
        OpenHapticsDevice device("", TACTOOTH_STANDIN_HD);
        ASSERT_TRUE(device.open());
        const Servo servo(device);
        // Hand (0.5 N/mm) and wall (0.4 N/mm) act in series over 4 mm. If the machine stalls, the device releases its
        // force, which returns only after the tool has lifted off.
        const auto isPressed = [] { return std::abs(force() - 4 / (1 / 0.5 + 1 / 0.4)) < 0.15; };
        EXPECT_TRUE(soon([&] { return lean() && soon(isPressed, 2s); }));
        standin().setButtons(3);
        EXPECT_TRUE(soon([&] { return servo.buttons() == 3; }));
        EXPECT_TRUE(soonSaysNothing(device));
    }
    EXPECT_EQ(force(), 0);
    EXPECT_LE(standin().strongestForce(), 3.3);
}

TEST_F(OpenHaptics, EachFailureToStartHasItsSentence) {
    EXPECT_THAT(openError("", "libNoSuchHD.so"), HasSubstr("install the device's driver and OpenHaptics"));
    EXPECT_THAT(openError("", TACTOOTH_LACKING_HD), HasSubstr("has no function hdDisableDevice"));
    EXPECT_THAT(openError("Third"), HasSubstr("look its name up in the vendor's setup program"));
    set(HdFault::InitError);
    EXPECT_THAT(openError(), HasSubstr("reports a fault"));
    set(HdFault::InUse);
    EXPECT_THAT(openError(), HasSubstr("close the other program"));
    set(HdFault::GarbageHandle);
    EXPECT_THAT(openError(), HasSubstr("look its name up"));
    set(HdFault::None);
    EXPECT_EQ(openError(), "") << "and after that it starts";
}

TEST_F(OpenHaptics, ANameThatIsNotSetUpIsDistinguishedFromAPenThatDoesNotAnswer) {
    const PenFolder pens({"Left", "Right"});
    const auto isUnknown = HasSubstr("choose one that is set up (Left, Right)");
    EXPECT_THAT(openError("left"), isUnknown);
    set(HdFault::LinkFault);  // some drivers report this for an unknown name
    EXPECT_THAT(openError("Third"), isUnknown);
    EXPECT_THAT(openError(), isUnknown) << "there is no default one";
    EXPECT_THAT(openError("Left"), HasSubstr("the device 'Left': The device does not answer"));
    set(HdFault::InUse);
    EXPECT_THAT(openError("Third"), HasSubstr("close the other program"));
    set(HdFault::GarbageHandle);
    EXPECT_THAT(openError("Left"), HasSubstr("look its name up"));
}

TEST_F(OpenHaptics, ClosedMidPressAPenHasNoForceFromThatMomentOn) {
    for (int i = 0; i < 3; ++i) {
        OpenHapticsDevice device("", TACTOOTH_STANDIN_HD);
        ASSERT_TRUE(device.open());
        auto servo = std::make_unique<Servo>(device);
        ASSERT_TRUE(lean());
        servo.reset();
        device.close();
        EXPECT_EQ(force(), 0);
    }
}

TEST_F(OpenHaptics, APenIsCalledByItsName) {
    OpenHapticsDevice device("Left", TACTOOTH_STANDIN_HD);
    ASSERT_TRUE(device.open());
    EXPECT_EQ(device.info().name, "Touch (stand-in) 'Left'");
}

TEST_F(OpenHaptics, TwoPensAreTwoDevicesAndOneCannotBeStartedTwice) {
    OpenHapticsDevice right("Right", TACTOOTH_STANDIN_HD);
    OpenHapticsDevice left("Left", TACTOOTH_STANDIN_HD);
    OpenHapticsDevice again("Left", TACTOOTH_STANDIN_HD);
    ASSERT_TRUE(right.open());
    ASSERT_TRUE(left.open());
    EXPECT_EQ(standin().startedPens(), 2);
    const auto opened = again.open();
    ASSERT_FALSE(opened);
    EXPECT_THAT(opened.error().message(), HasSubstr("the device 'Left': The device is in use"));
    const Servo servo(right);
    const Servo other(left);
    EXPECT_TRUE(lean());
    EXPECT_TRUE(soon([&] { return other.ticks() > 50; }));
}

/// A fault that makes the pen unavailable while it presses.
struct Loss {
    HdFault fault;
    const char* name;
    const char* sentence;
};

class OpenHapticsLoss : public OpenHaptics, public ::testing::WithParamInterface<Loss> {};

TEST_P(OpenHapticsLoss, MidPressGivesNoForceAndASentenceAndThePenComesBack) {
    OpenHapticsDevice device("", TACTOOTH_STANDIN_HD);
    ASSERT_TRUE(device.open());
    const Servo servo(device);
    ASSERT_TRUE(lean());
    set(GetParam().fault);
    EXPECT_TRUE(soonSays(device, GetParam().sentence));
    std::this_thread::sleep_for(100ms);
    EXPECT_EQ(standin().strongestWhileFaulty(), 0) << "from 5 ms on";
    if (device.faultMessage() != nullptr) {
        EXPECT_THAT(device.faultMessage()->in(Language::English), HasSubstr(GetParam().sentence));
    }
    EXPECT_LE(standin().lastForceSinceFault(), kBadReading)
        << "its force is taken back in the tick that reports the fault";
    RecordProperty("last_tick_with_force", std::to_string(standin().lastForceSinceFault()));
    set(HdFault::None);
    EXPECT_TRUE(soonSaysNothing(device));
    EXPECT_TRUE(lean());
}

INSTANTIATE_TEST_SUITE_P(All, OpenHapticsLoss,
                         ::testing::Values(Loss{HdFault::LinkFault, "LinkFault", "does not answer"},
                                           Loss{HdFault::DeviceFault, "DeviceFaultMotorsAlive", "reports a fault"},
                                           Loss{HdFault::ErrorFlood, "ErrorFlood", "does not answer"},
                                           Loss{HdFault::Unplugged, "Unplugged", "has stopped answering"}),
                         [](const auto& one) { return one.param.name; });

TEST_F(OpenHaptics, OfDriverAndModelTheSmallerForceCounts) {
    OpenHapticsDevice device("", TACTOOTH_STANDIN_HD);
    set(HdFault::Boast);
    ASSERT_TRUE(device.open());
    EXPECT_EQ(device.info().limits.force, 3.3);
    EXPECT_EQ(device.info().limits.continuousForce, 0.88);
    set(HdFault::Weak);
    ASSERT_TRUE(device.open());
    EXPECT_EQ(device.info().limits.force, 1);
    EXPECT_EQ(device.info().limits.continuousForce, 0.4);
}

struct BadPose {
    HdFault fault;
    const char* name;
    const char* sentence;
};

class OpenHapticsPoses : public OpenHaptics, public ::testing::WithParamInterface<BadPose> {};

TEST_P(OpenHapticsPoses, ThatNoHandCanHaveGiveNoForceAndASentenceAndThePenComesBack) {
    {
        const HdFault fault = GetParam().fault;
        standin().reset();
        OpenHapticsDevice device("", TACTOOTH_STANDIN_HD);
        ASSERT_TRUE(device.open());
        const Servo servo(device);
        ASSERT_TRUE(lean());
        set(fault);
        std::this_thread::sleep_for(100ms);
        EXPECT_EQ(standin().strongestWhileFaulty(), 0);
        EXPECT_LE(standin().lastForceSinceFault(), kBadReading + 2) << "2 ms of the device's own time";
        EXPECT_LE(servo.oldestWithForce(), kLoss);
        RecordProperty("last_tick_with_force", std::to_string(standin().lastForceSinceFault()));
        EXPECT_TRUE(soonSays(device, GetParam().sentence));
        set(HdFault::None);
        EXPECT_TRUE(lean());
        EXPECT_LE(standin().strongestForce(), device.info().limits.force);
    }
}

INSTANTIATE_TEST_SUITE_P(All, OpenHapticsPoses,
                         ::testing::Values(BadPose{HdFault::NanPose, "NoNumber", "is not a number"},
                                           BadPose{HdFault::Jump, "Jump", "position has jumped"},
                                           BadPose{HdFault::Jitter, "Jitter", "position has jumped"},
                                           BadPose{HdFault::Drift, "Drift", "position has jumped"},
                                           BadPose{HdFault::BentAxes, "BentAxes", "an orientation that is not valid"},
                                           BadPose{HdFault::FlippingTurn, "FlippingTurn", "orientation has jumped"}),
                         [](const auto& one) { return one.param.name; });

TEST_F(OpenHaptics, ADriverThatCallsTwentyTimesTooOftenIsLimpAndComesBack) {
    OpenHapticsDevice device("", TACTOOTH_STANDIN_HD);
    ASSERT_TRUE(device.open());
    const Servo servo(device);
    ASSERT_TRUE(lean());
    set(HdFault::Flood);
    EXPECT_TRUE(soonSays(device, "calls far too often"));
    EXPECT_TRUE(soon([] { return force() == 0; }));
    RecordProperty("last_tick_with_force", std::to_string(standin().lastForceSinceFault()));
    const double began = monotonicSeconds();
    const long before = servo.ticks();
    std::this_thread::sleep_for(200ms);
    const auto ticks = static_cast<double>(servo.ticks() - before);
    EXPECT_LE(ticks, 1.1 * 5000 * (monotonicSeconds() - began)) << "the servo leaves time to others";
    EXPECT_EQ(force(), 0);
    set(HdFault::None);
    EXPECT_TRUE(lean());
}

TEST_F(OpenHaptics, TemperaturesThatAreNoNumberCountAsHot) {
    OpenHapticsDevice device("", TACTOOTH_STANDIN_HD);
    ASSERT_TRUE(device.open());
    const Servo servo(device);
    set(HdFault::NanHeat);
    ASSERT_TRUE(pressUntil([&] { return force() > 0.85 && servo.state() == ForceState::Warm; }));
    EXPECT_LE(force(), 0.88 + 1e-9);
}

TEST_F(OpenHaptics, APenThatIsNotCalibratedIsLimpAndSaysWhatToDo) {
    set(HdFault::NeedsInkwell);
    OpenHapticsDevice device("", TACTOOTH_STANDIN_HD);
    ASSERT_TRUE(device.open());
    const Servo servo(device);
    standin().wantPosition(0, kWall - 4, 0);
    ASSERT_TRUE(soonSays(device, "into its inkwell"));
    std::this_thread::sleep_for(200ms);
    EXPECT_EQ(force(), 0);
    set(HdFault::None);
    EXPECT_TRUE(soonSaysNothing(device));
    EXPECT_TRUE(lean());
}

TEST_F(OpenHaptics, WarmMotorsAreSpared) {
    OpenHapticsDevice device("", TACTOOTH_STANDIN_HD);
    ASSERT_TRUE(device.open());
    const Servo servo(device);
    ASSERT_TRUE(pressUntil([] { return force() > 1.5; }));
    set(HdFault::WarmMotors);
    const auto isSpared = [&] { return servo.state() == ForceState::Warm && force() < 0.9; };
    EXPECT_TRUE(soon(isSpared, 2s) || pressUntil(isSpared));
    EXPECT_TRUE(soonSays(device, "motors are warm"));
}

TEST_F(OpenHaptics, ACutForceIsSaidAndTheSessionGoesOn) {
    OpenHapticsDevice device("", TACTOOTH_STANDIN_HD);
    ASSERT_TRUE(device.open());
    const Servo servo(device);
    EXPECT_TRUE(soon([&] {  // a stall of the machine at that moment would end the force, too
        const bool leans = lean();
        set(HdFault::TooMuchForce);
        return leans && soonSays(device, "press more gently") && soon([] { return force() > 0.3; }, 2s);
    }));
    EXPECT_TRUE(soonSaysNothing(device)) << "it is not shown for ever";
}

TEST_F(OpenHaptics, AStallOfTheDriverStartsTheForceFromZeroAgain) {
    OpenHapticsDevice device("", TACTOOTH_STANDIN_HD);
    ASSERT_TRUE(device.open());
    const Servo servo(device);
    ASSERT_TRUE(lean());
    const std::uint64_t before = servo.faults();
    set(HdFault::Stall);
    EXPECT_TRUE(soon([&] { return servo.faults() > before; }));
    std::this_thread::sleep_for(20ms);
    EXPECT_LE(standin().lastForceSinceFault(), kBadReading + 2) << "none in the ticks after the stall";
    EXPECT_TRUE(lean());
}

TEST_F(OpenHaptics, APenThatLosesItsCalibrationGoesLimpAtOnce) {
    OpenHapticsDevice device("", TACTOOTH_STANDIN_HD);
    ASSERT_TRUE(device.open());
    const Servo servo(device);
    ASSERT_TRUE(lean());
    set(HdFault::NeedsInkwell);
    EXPECT_TRUE(soonSays(device, "into its inkwell"));
    std::this_thread::sleep_for(20ms);
    EXPECT_EQ(standin().lastForceSinceFault(), 0);
    EXPECT_EQ(standin().strongestWhileFaulty(), 0);
    set(HdFault::None);
    EXPECT_TRUE(lean());
}

TEST_F(OpenHaptics, ALostPenLeavesTheOtherHandAlone) {
    OpenHapticsDevice right("Right", TACTOOTH_STANDIN_HD);
    OpenHapticsDevice left("Left", TACTOOTH_STANDIN_HD);
    ASSERT_TRUE(right.open());
    ASSERT_TRUE(left.open());
    const Servo servo(right);
    const Servo other(left);
    ASSERT_TRUE(lean());
    const int before = standin().schedulerStarts();
    standin().setFaultyPen(1);
    set(HdFault::LinkFault);
    EXPECT_TRUE(soonSays(left, "does not answer"));
    bool keptForce = true;
    for (int i = 0; i < 250; ++i) {  // in 2.5 s a lost pen would be retried twice
        std::this_thread::sleep_for(10ms);
        keptForce &= force() > 0;
    }
    if (keptForce) {  // otherwise the machine has stalled, and there was no force to interrupt
        EXPECT_EQ(standin().schedulerStarts(), before);
    }
    EXPECT_TRUE(lean());
    EXPECT_TRUE(soonSaysNothing(right));
    set(HdFault::None);
    standin().wantPosition(0, 5, 0);  // a device that renders no force may be interrupted for the time of a start
    EXPECT_TRUE(soonSaysNothing(left));
}

TEST_F(OpenHaptics, AServoThatHangsRendersNothing) {
    OpenHapticsDevice device("", TACTOOTH_STANDIN_HD);
    ASSERT_TRUE(device.open());
    Servo servo(device);
    ASSERT_TRUE(lean());
    set(HdFault::None);  // starts the count
    servo.hang(300ms);
    EXPECT_TRUE(soon([] { return force() == 0; }));
    EXPECT_LT(standin().lastForceSinceFault(), 200) << "the driver's callback did it, not the servo";
    EXPECT_TRUE(lean());
}

}  // namespace
}  // namespace tactooth
