// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/process/hand_link.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "devices/base/device_presets.h"
#include "devices/process/hand_memory.h"
#include "devices/process/messages.h"
#include "devices/simulated/simulated_driver.h"

namespace tactooth {
namespace {

// The layout of version 1: a change of one of these needs another version.
static_assert(sizeof(ForceMessage) == 72 && sizeof(PoseMessage) == 136 && sizeof(HandText) == 2048);
static_assert(sizeof(DeviceDescription) == 256 + sizeof(ForceLimits) + sizeof(PoseLimits) + 56 + 32);
static_assert(std::is_standard_layout_v<HandLink> && alignof(HandLink) == 64);

TEST(HandLink, CarriesWhatADeviceIs) {
    const SimulatedDriver device;
    const DeviceDescription description = descriptionOf(device);
    const auto info = infoFrom(description);
    ASSERT_TRUE(info);
    EXPECT_EQ(info->name, device.info().name);
    EXPECT_TRUE(info->rendersForce && info->sensesRotation && !info->hasPedal && !info->isInToothFrame);
    EXPECT_EQ(info->workspace, device.info().workspace);
    EXPECT_FALSE(info->workspaceCentre);
    EXPECT_EQ(info->stiffness, device.info().stiffness);
    EXPECT_EQ(std::memcmp(&info->limits, &device.info().limits, sizeof(ForceLimits)), 0);
    EXPECT_EQ(std::memcmp(&info->poseLimits, &device.info().poseLimits, sizeof(PoseLimits)), 0);
    EXPECT_EQ(description.drivesServoRate, 1U);
}

TEST(HandLink, RefusesLimitsThatNoLimiterTakes) {
    const DeviceDescription good = descriptionOf(SimulatedDriver());
    for (const double bad : {std::nan(""), -1.0}) {
        for (double DeviceDescription::*const value : {&DeviceDescription::stiffness}) {
            DeviceDescription broken = good;
            broken.*value = bad;
            EXPECT_FALSE(infoFrom(broken)) << bad;
        }
        for (double ForceLimits::*const value :
             {&ForceLimits::force, &ForceLimits::torque, &ForceLimits::slew, &ForceLimits::tickTimeout,
              &ForceLimits::continuousForce, &ForceLimits::power}) {
            DeviceDescription broken = good;
            broken.limits.*value = bad;
            EXPECT_FALSE(infoFrom(broken)) << bad;
        }
        DeviceDescription broken = good;
        broken.poseLimits.speed = bad;
        EXPECT_FALSE(infoFrom(broken)) << bad;
    }
    DeviceDescription unbounded = good;
    unbounded.limits.continuousForce = std::numeric_limits<double>::infinity();
    unbounded.stiffness = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(infoFrom(unbounded));
}

TEST(HandLink, CarriesASampleAndAForce) {
    DeviceSample sample;
    sample.hand = {Vec3(1, 2, 3), Quat(0.8, 0.6, 0, 0)};
    sample.pedal = 0.25;
    sample.buttons = 5;
    sample.motorTemperature = 0.5;
    sample.connected = false;
    const DeviceSample back = sampleFrom(poseMessageOf(sample));
    EXPECT_EQ(back.hand.position, sample.hand.position);
    EXPECT_EQ(back.hand.rotation.coeffs(), sample.hand.rotation.coeffs());
    EXPECT_EQ(back.pedal, 0.25);
    EXPECT_EQ(back.buttons, 5U);
    EXPECT_EQ(back.motorTemperature, 0.5);
    EXPECT_FALSE(back.connected);
    SafetyLimiter limiter{ForceLimits()};
    (void)limiter.limit({}, 0.001, true, 0);
    const SafeWrench wrench = limiter.limit({Vec3(0.1, 0.2, -0.3), Vec3::Zero()}, 0.001, true, 0);
    EXPECT_EQ(wrenchFrom(forceMessageOf(wrench)).force, wrench.force());
}

TEST(HandLink, CarriesASentenceInBothLanguagesAndCutsWholeLetters) {
    EXPECT_FALSE(messageFrom(HandText()));
    const Message sentence(msg::kHandIsSilent);
    const auto back = messageFrom(handTextOf(sentence));
    ASSERT_TRUE(back);
    EXPECT_EQ(back->in(Language::English), sentence.in(Language::English));
    EXPECT_EQ(back->in(Language::Japanese), sentence.in(Language::Japanese));
    std::string many;
    for (int i = 0; i < 1000; ++i) many += "歯";  // three bytes each
    const std::string cut = messageFrom(handTextOf(Message::bilingual("x", many)))->in(Language::Japanese);
    EXPECT_EQ(cut.size(), 1023U / 3 * 3);
    EXPECT_TRUE(many.starts_with(cut));
}

TEST(HandLink, CountsWrapAround) {
    EXPECT_TRUE(follows(1, 0, 1));
    EXPECT_TRUE(follows(0, 0xFFFFFFFF, 1));
    EXPECT_TRUE(follows(4, 0xFFFFFFFF, 5));
    EXPECT_FALSE(follows(5, 0xFFFFFFFF, 5));
    EXPECT_FALSE(follows(7, 7, 1000));
    EXPECT_FALSE(follows(6, 7, 1000));
}

TEST(HandMemory, IsSharedByItsFileAndKeepsItsSize) {
    const auto memory = HandMemory::create();
    ASSERT_TRUE(memory);
    const auto other = HandMemory::open(dup(memory->file()));
    ASSERT_NE(other, nullptr);
    memory->link().handBell.ring();
    EXPECT_EQ(other->link().handBell.rings(), 1U);
    EXPECT_NE(ftruncate(memory->file(), 0), 0) << "a shorter file would end the other process";
}

TEST(HandMemory, OfAnotherVersionIsNotUsed) {
    const auto memory = HandMemory::create();
    ASSERT_TRUE(memory);
    memory->link().version = kHandLinkVersion + 1;
    EXPECT_EQ(HandMemory::open(dup(memory->file())), nullptr);
    int pipe[2];
    ASSERT_EQ(::pipe(pipe), 0);
    EXPECT_EQ(HandMemory::open(pipe[0]), nullptr);
    close(pipe[0]);
    close(pipe[1]);
    EXPECT_EQ(HandMemory::open(-1), nullptr);
}

}  // namespace
}  // namespace tactooth
