// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/haply/haply_device.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "standin/plane_servo.h"
#include "standin/standin_haply.h"

namespace tactooth {
namespace {

using namespace std::chrono_literals;
using test::HaplyFault;
using test::kWall;
using test::PlaneServo;
using test::soon;
using test::soonSays;
using test::soonSaysNothing;
using test::StandinHaply;
using ::testing::HasSubstr;

constexpr double kLoss = 0.005;       // s after which a lost device renders no force
constexpr double kMillimetre = 1e-3;  // m

/// Waits for so many more messages: the hand moves by a millisecond with each of them.
bool pass(const StandinHaply& service, long messages) {
    const long before = service.messages();
    return soon([&service, before, messages] { return service.messages() > before + messages; }, 10s);
}

/// Lifts off and presses on the plane until a force acts. A busy machine only slows it: it counts in messages.
bool lean(StandinHaply& service) {
    constexpr long kLift = 150, kPress = 300;  // messages: above the plane a fault needs 100 until it is over
    const auto isPressed = [&service] { return service.force() > 0.3; };
    return soon([&service, &isPressed] {
        service.wantPosition(0, 0, 5 * kMillimetre);
        if (!pass(service, kLift)) return false;
        service.wantPosition(0, 0, (kWall - 4) * kMillimetre);
        return pass(service, kPress) && isPressed();
    });
}

std::string openError(const std::string& name, const std::string& address) {
    HaplyDevice device(name, address);
    const auto opened = device.open();
    return opened ? "" : opened.error().message();
}

TEST(HaplyDevice, DescribesTheDevice) {
    StandinHaply service;
    HaplyDevice device("", service.address());
    ASSERT_TRUE(device.open());
    EXPECT_EQ(device.info().name, "Haply Inverse3 049D");
    EXPECT_EQ(device.info().limits.force, 10);
    EXPECT_EQ(device.info().limits.continuousForce, 2.5);
    EXPECT_EQ(device.info().stiffness, 0.8);
    EXPECT_EQ(device.info().buttonCount, 3);
    EXPECT_TRUE(device.info().sensesRotation);
    EXPECT_FALSE(device.drivesServoRate());
    HaplyDevice second(StandinHaply::kSecond, service.address());
    ASSERT_TRUE(second.open());
    EXPECT_FALSE(second.info().sensesRotation) << "there is one grip, and the first arm has it";
    EXPECT_EQ(service.connections(), 2);
    device.close();
    second.close();
    EXPECT_TRUE(soon([&] { return service.connections() == 0; }));
}

TEST(HaplyDevice, TouchesAPlaneAndStops) {
    StandinHaply service;
    {
        HaplyDevice device("", service.address());
        ASSERT_TRUE(device.open());
        const PlaneServo servo(device);
        // Hand (0.5 N/mm) and wall (0.4 N/mm) act in series over 4 mm. If the machine stalls, the device releases its
        // force, which returns only after the tool has lifted off.
        const auto isPressed = [&] { return std::abs(service.force() - 4 / (1 / 0.5 + 1 / 0.4)) < 0.15; };
        EXPECT_TRUE(soon([&] { return lean(service) && soon(isPressed, 2s); }));
        service.setGrip({1, 0, 0, 0}, 5);
        EXPECT_TRUE(soon([&] { return servo.buttons() == 5; }));
        EXPECT_TRUE(soonSaysNothing(device));
    }
    EXPECT_TRUE(soon([&] { return service.connections() == 0; }));
    EXPECT_EQ(service.lastForceReceived(), 0);
    EXPECT_EQ(service.force(), 0);
}

TEST(HaplyDevice, ANoughtIsAForceThatIsSentToo) {
    StandinHaply service;
    HaplyDevice device("", service.address());
    ASSERT_TRUE(device.open());
    const long before = service.messages();
    EXPECT_TRUE(soon([&] { return service.messages() > before + 50; })) << "also before there is a servo";
    const PlaneServo servo(device);
    service.setFault(HaplyFault::None);  // starts the count
    EXPECT_TRUE(soon([&] { return service.messagesSinceFault() > 200; }));
    EXPECT_EQ(service.lastForceSinceFault(), 0);
}

TEST(HaplyDevice, EachFailureToStartHasItsSentence) {
    std::string nobody;
    {
        const StandinHaply gone;
        nobody = gone.address();
    }
    EXPECT_THAT(openError("", nobody), HasSubstr("does not answer at " + nobody + ": install and start it"));
    EXPECT_THAT(openError("", "no address"), HasSubstr("does not answer at no address"));
    StandinHaply service;
    EXPECT_THAT(openError("FFFF", service.address()), HasSubstr("knows no Inverse3 'FFFF': it finds 049D, 0B1C"));
    service.setFirstMessage(R"({"session_id":1,"inverse3":[]})");
    EXPECT_THAT(openError("", service.address()), HasSubstr("finds no Inverse3"));
    service.setFirstMessage("");
    service.setFault(HaplyFault::Malformed);
    EXPECT_THAT(openError("", service.address()), HasSubstr("messages that cannot be read"));
    service.setFault(HaplyFault::Version);
    EXPECT_THAT(openError("", service.address()), HasSubstr("install version 3"));
    service.setFault(HaplyFault::Units);
    EXPECT_THAT(openError("", service.address()), HasSubstr("not in metres"));
    service.setFault(HaplyFault::Mute);
    EXPECT_THAT(openError("", service.address()), HasSubstr("has stopped answering"));
    service.setFault(HaplyFault::Drop);
    EXPECT_THAT(openError("", service.address()), HasSubstr("has closed the connection"));
    service.setFault(HaplyFault::None);
    service.setForeign(true);
    EXPECT_THAT(openError("", service.address()), HasSubstr("is not the Haply Inverse Service"));
    service.setForeign(false);
    EXPECT_EQ(openError("", service.address()), "") << "and after that it starts";
}

/// Whether the device reports this fault now.
bool says(const HapticDevice& device, const std::string& part) {
    const Message* const faultMessage = device.faultMessage();
    return faultMessage != nullptr && faultMessage->in(Language::English).find(part) != std::string::npos;
}

struct Fault {
    HaplyFault fault;
    const char* name;
    const char* sentence;
    bool isLoss;  ///< no new reading arrives, or it is rejected
};

class HaplyFaults : public ::testing::TestWithParam<Fault> {};

TEST_P(HaplyFaults, MidPressGiveNoForceAndASentenceAndTheDeviceComesBack) {
    const Fault& fault = GetParam();
    StandinHaply service;
    HaplyDevice device("", service.address());
    ASSERT_TRUE(device.open());
    const PlaneServo servo(device);
    ASSERT_TRUE(lean(service));
    service.setFault(fault.fault);
    EXPECT_TRUE(soonSays(device, fault.sentence));
    EXPECT_TRUE(soon([&] { return service.force() == 0; }));
    std::this_thread::sleep_for(50ms);
    EXPECT_EQ(service.force(), 0);
    EXPECT_LE(servo.oldestWithForce(), kLoss);
    EXPECT_LE(servo.strongest(), device.info().limits.force);
    RecordProperty("last_message_with_force", std::to_string(service.lastForceSinceFault()));
    RecordProperty("oldest_pose_ms", std::to_string(1e3 * servo.oldestWithForce()));
    if (fault.isLoss) {
        // One force for the last good answer, and the forces that the servo thread wrote while the device waited for
        // the next answer.
        EXPECT_LE(service.lastForceSinceFault(), 6);
    } else {
        // One force was being sent when the bad answer arrived, and one may have been written before it was read.
        EXPECT_LE(service.lastForceSinceFault(), 3);
    }
    service.setFault(HaplyFault::None);
    EXPECT_TRUE(lean(service)) << "the same device goes on";
}

INSTANTIATE_TEST_SUITE_P(
    All, HaplyFaults,
    ::testing::Values(Fault{HaplyFault::Drop, "Drop", "has closed the connection", true},
                      Fault{HaplyFault::Slow, "Slow", "answers too slowly", true},
                      Fault{HaplyFault::Mute, "Mute", "The Haply Inverse Service", true},
                      Fault{HaplyFault::Malformed, "Malformed", "messages that cannot be read", true},
                      Fault{HaplyFault::Version, "Version", "install version 3", true},
                      Fault{HaplyFault::Units, "Units", "not in metres", true},
                      Fault{HaplyFault::Gone, "Gone", "is gone", true},
                      Fault{HaplyFault::NotANumber, "NoNumber", "has lost its position", false},
                      Fault{HaplyFault::Jump, "Jump", "has jumped", false},
                      Fault{HaplyFault::Double, "Double", "sends more answers", true},
                      Fault{HaplyFault::Twenty, "Twenty", "sends more answers", true},
                      Fault{HaplyFault::Flood, "Flood", "sends more answers", true},
                      Fault{HaplyFault::InvalidRotation, "BrokenTurn", "an orientation that is not valid", false},
                      Fault{HaplyFault::FlippingTurn, "FlippingTurn", "orientation has jumped", false},
                      Fault{HaplyFault::Jitter, "Jitter", "position has jumped", false},
                      Fault{HaplyFault::Drift, "Drift", "position has jumped", false},
                      Fault{HaplyFault::NoPower, "NoPower", "plug in its power supply", false},
                      Fault{HaplyFault::NotCalibrated, "NotCalibrated", "is not calibrated", false},
                      Fault{HaplyFault::NotReady, "NotReady", "is not ready", false}),
    [](const auto& one) { return one.param.name; });

TEST(HaplyDevice, AQuaternionThatChangesItsSignsIsTheSameTurnAndNoFault) {
    StandinHaply service;
    HaplyDevice device("", service.address());
    ASSERT_TRUE(device.open());
    const PlaneServo servo(device);
    service.setGrip({0.8, 0.6, 0, 0}, 0);
    service.setFault(HaplyFault::NegatedTurn);
    EXPECT_TRUE(lean(service));
    EXPECT_FALSE(says(device, "orientation"));
}

TEST(HaplyDevice, ClosedMidPressItsLastMessageIsAForceOfZero) {
    StandinHaply service;
    HaplyDevice device("", service.address());
    ASSERT_TRUE(device.open());
    {
        const PlaneServo servo(device);
        ASSERT_TRUE(lean(service));
    }
    const long before = service.messages();
    device.close();
    EXPECT_TRUE(soon([&] { return service.messages() > before && service.connections() == 0; }));
    EXPECT_EQ(service.lastForceReceived(), 0);
}

TEST(HaplyDevice, AGripThatIsGoneKeepsItsDirection) {
    StandinHaply service;
    HaplyDevice device("", service.address());
    service.setGrip({0.8, 0.6, 0, 0}, 0);
    ASSERT_TRUE(device.open());
    const Quat turn(0.8, 0.6, 0, 0);
    ASSERT_TRUE(soon([&] { return device.read(0.001).hand.rotation.angularDistance(turn) < 1e-6; }));
    service.setGripThere(false);
    const long before = service.messages();
    ASSERT_TRUE(soon([&] { return device.write({}), service.messages() > before + 20; }));
    EXPECT_TRUE(soon([&] {
        device.write({});
        const DeviceSample sample = device.read(0.001);
        EXPECT_LT(sample.hand.rotation.angularDistance(turn), 1e-6);
        return sample.connected;  // not while the last answer is some milliseconds old
    }));
}

TEST(HaplyDevice, AFaultThatIsOverIsNotShownForEver) {
    StandinHaply service;
    HaplyDevice device("", service.address());
    ASSERT_TRUE(device.open());
    const PlaneServo servo(device);
    service.setFault(HaplyFault::NoPower);
    ASSERT_TRUE(soon([&] { return device.faultMessage() != nullptr; }));
    service.setFault(HaplyFault::None);
    EXPECT_TRUE(soon([&] { return device.faultMessage() == nullptr; }));
}

TEST(HaplyDevice, OneLateAnswerEndsTheForceAndIsNotWorthASentence) {
    StandinHaply service;
    HaplyDevice device("", service.address());
    ASSERT_TRUE(device.open());
    const PlaneServo servo(device);
    const auto isSilent = [&] {  // on a machine that stalls itself meanwhile, other answers are late too
        if (!lean(service) || !soonSaysNothing(device)) return false;
        const std::uint64_t faults = servo.faults();
        service.setFault(HaplyFault::Hiccup);
        return soon([&] { return servo.faults() > faults; }) && pass(service, 100) && device.faultMessage() == nullptr;
    };
    EXPECT_TRUE(soon(isSilent));
    EXPECT_LE(servo.oldestWithForce(), kLoss);
    EXPECT_TRUE(lean(service));
}

TEST(HaplyDevice, AServoThatHangsRendersNothing) {
    StandinHaply service;
    HaplyDevice device("", service.address());
    ASSERT_TRUE(device.open());
    PlaneServo servo(device);
    ASSERT_TRUE(lean(service));
    service.setFault(HaplyFault::None);  // starts the count
    servo.hang(300ms);
    EXPECT_TRUE(soon([&] { return service.messagesSinceFault() > 50 && service.force() == 0; }))
        << "the thread of the link did it, not the servo";
    EXPECT_TRUE(lean(service));
}

}  // namespace
}  // namespace tactooth
