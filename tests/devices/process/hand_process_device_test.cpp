// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The program's end of the link, with a real tactooth-hand behind it whose device is simulated.
#include "devices/process/hand_process_device.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <thread>

#include "devices/base/monotonic_clock.h"
#include "devices/open_device.h"
#include "devices/simulated/simulated_driver.h"
#include "process/parent_program.h"
#include "standin/plane_servo.h"
#include "support/heap_counter.h"
#include "support/scoped_variable.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

using namespace std::chrono_literals;
using test::PlaneServo;
using test::soon;
using test::soonSays;
using test::soonSaysNothing;
using ::testing::HasSubstr;

HandRequest simulatedDevice(const std::filesystem::path& log) {
    HandRequest request;
    request.device = std::string(SimulatedDriver::kName);
    request.faultLog = log;
    return request;
}

class HandProcess : public ::testing::Test {
protected:
    [[nodiscard]] std::unique_ptr<HandProcessDevice> make() const {
        return std::make_unique<HandProcessDevice>(simulatedDevice(log_));
    }
    test::TemporaryFolder folder_;
    std::filesystem::path log_ = folder_ / "log.csv";
};

TEST_F(HandProcess, IsWhatItsDeviceIs) {
    const auto device = make();
    ASSERT_TRUE(device->open());
    const SimulatedDriver itself;
    EXPECT_EQ(device->info().name, itself.info().name);
    EXPECT_EQ(device->info().limits.force, itself.info().limits.force);
    EXPECT_EQ(device->info().workspace, itself.info().workspace);
    EXPECT_TRUE(device->drivesServoRate());
    EXPECT_EQ(device->faultMessage(), nullptr);
    EXPECT_NE(device->processId(), 0);
}

TEST_F(HandProcess, WakesTheServoAtTheDevicesPaceWithFreshSamples) {
    const auto device = make();
    ASSERT_TRUE(device->open());
    int fresh = 0;
    double oldest = 0, took = 0;    // s
    const auto isAtItsPace = [&] {  // a machine that stalls now and then leaves it half a second in between
        device->waitForTick(1);
        fresh = 0;
        oldest = 0;
        const double start = monotonicSeconds();
        for (int i = 0; i < 500; ++i) {
            device->waitForTick(1);
            const DeviceSample sample = device->read(0.001);
            fresh += sample.isFresh ? 1 : 0;
            if (sample.connected) oldest = std::max(oldest, sample.age);
            device->write({});
        }
        took = monotonicSeconds() - start;
        return fresh > 450 && std::abs(took - 0.5) < 0.2 && oldest < 0.005;
    };
    EXPECT_TRUE(soon(isAtItsPace)) << fresh << " fresh, the oldest of " << oldest << " s, in " << took << " s";
    EXPECT_GT(device->addedLatency().total(), 400U);
    EXPECT_GT(device->responseTime().quantile(0.5), 0);
    EXPECT_TRUE(soon([&] { return !(device->read(0).isFresh && device->read(0).isFresh); }))
        << "the same sample twice is not fresh";
}

TEST_F(HandProcess, TheServosCallsAllocateNothing) {
    const auto device = make();
    ASSERT_TRUE(device->open());
    const auto run = [&](int ticks) {
        for (int i = 0; i < ticks; ++i) {
            device->waitForTick(0.002);
            (void)device->read(0.001);
            device->write({});
            device->recordPoseFault(PoseFault::None, 0.001);
        }
    };
    run(100);
    const long before = test::heapCalls();
    run(200);
    EXPECT_EQ(test::heapCalls(), before);
}

TEST_F(HandProcess, ClosedItsProcessEndsInOrderAndNothingIsLogged) {
    const auto device = make();
    ASSERT_TRUE(device->open());
    const pid_t process = device->processId();
    { const PlaneServo servo(*device); }
    device->close();
    EXPECT_TRUE(test::hasEnded(process));
    EXPECT_EQ(device->processId(), 0);
    EXPECT_TRUE(readFaults(log_, 10).empty());
    EXPECT_EQ(device->faultMessage(), nullptr);
    ASSERT_TRUE(device->open()) << "and it opens again";
    EXPECT_NE(device->processId(), process);
}

TEST_F(HandProcess, AProcessThatIsKilledIsSaidLoggedAndStartedAgain) {
    const auto device = make();
    ASSERT_TRUE(device->open());
    const PlaneServo servo(*device);
    const pid_t process = device->processId();
    kill(process, SIGKILL);
    EXPECT_TRUE(soonSays(*device, "The device's process is gone (signal: Killed), so the force is off"));
    EXPECT_TRUE(soonSaysNothing(*device)) << "another one runs";
    EXPECT_NE(device->processId(), process);
    const auto records = readFaults(log_, 10);
    ASSERT_EQ(records.size(), 1U);
    EXPECT_EQ(records[0].cause, HandFault::HandKilled);
    EXPECT_EQ(records[0].device, device->info().name);
    const long before = servo.ticks();
    EXPECT_TRUE(soon([&] { return servo.ticks() > before + 200; })) << "the servo goes on";
}

TEST_F(HandProcess, TheServoNeitherWaitsNorCountsALostProcessAsConnected) {
    const auto device = make();
    ASSERT_TRUE(device->open());
    ASSERT_TRUE(soon([&] { return device->waitForTick(0.01), device->read(0.001).connected; }));
    kill(device->processId(), SIGKILL);
    EXPECT_TRUE(soon([&] { return device->processId() == 0; }));
    int prompt = 0;
    constexpr int kTicks = 50;
    for (int i = 0; i < kTicks; ++i) {
        const double start = monotonicSeconds();
        device->waitForTick(0.001);
        const bool isConnected = device->read(0.001).connected;
        device->write({});
        prompt += monotonicSeconds() - start < 0.01 ? 1 : 0;
        if (device->processId() == 0) {  // on a slow machine the next process may be there already
            EXPECT_FALSE(isConnected);
        }
    }
    EXPECT_GT(prompt, kTicks / 2) << "a busy machine delays some of them";
}

TEST_F(HandProcess, AProcessThatEndsAgainAndAgainIsGivenUp) {
    const auto device = make();
    ASSERT_TRUE(device->open());
    for (int i = 0; i <= HandSupervisor::kMaxRestarts; ++i) {
        ASSERT_TRUE(soon([&] { return device->processId() != 0; }));
        const pid_t process = device->processId();
        kill(process, SIGKILL);
        ASSERT_TRUE(soon([&] { return device->processId() != process; }));
    }
    EXPECT_TRUE(soonSays(*device, "choose the device again"));
    device->close();
    EXPECT_TRUE(device->open());
    EXPECT_EQ(device->faultMessage(), nullptr);
}

TEST_F(HandProcess, AMissingProgramIsSaidWithItsRemedy) {
    HandRequest request = simulatedDevice(log_);
    request.program = folder_ / "tactooth-hand";
    HandProcessDevice device(request);
    const auto opened = device.open();
    ASSERT_FALSE(opened);
    EXPECT_THAT(opened.error().message(), HasSubstr("tactooth-hand, which holds the device, cannot be started"));
    EXPECT_THAT(opened.error().message(), HasSubstr("--device-in-process"));
    EXPECT_FALSE(device.read(0.001).connected);
    device.write({});
}

TEST_F(HandProcess, AProgramThatIsNotTheRightOneIsSaid) {
    HandRequest request = simulatedDevice(log_);
    request.program = folder_ / "tactooth-hand";
    const auto with = [&](const std::string& script) {
        std::ofstream(request.program) << "#!/bin/sh\n" << script << '\n';
        std::filesystem::permissions(request.program, std::filesystem::perms::owner_all);
        const auto opened = HandProcessDevice(request).open();
        return opened ? std::string() : opened.error().message();
    };
    EXPECT_THAT(with("exit 3"), HasSubstr("belongs to another version"));
    EXPECT_THAT(with("exit 0"), HasSubstr("ends while it opens the device (the device's process ended by itself)"));
    EXPECT_THAT(with("kill -SEGV $$"), HasSubstr("ends while it opens the device (signal: Segmentation fault"));
}

TEST_F(HandProcess, ADeviceThatDoesNotOpenIsSaidInBothLanguages) {
    const test::ScopedVariable library("TACTOOTH_LIBHD", "libNoSuchHD.so");
    HandRequest request = simulatedDevice(log_);
    request.device = "pen";
    const auto opened = HandProcessDevice(request).open();
    ASSERT_FALSE(opened);
    EXPECT_THAT(opened.error().message(), HasSubstr("install the device's driver and OpenHaptics"));
    EXPECT_THAT(opened.error().in(Language::Japanese), HasSubstr("libNoSuchHD.so を読み込めません"));
    EXPECT_TRUE(readFaults(log_, 10).empty());
}

TEST_F(HandProcess, IsOnlyAProgramOfTactooth) {
    EXPECT_EQ(handProgram().filename(), "tactooth-hand");
    EXPECT_TRUE(std::filesystem::exists(handProgram()));
    EXPECT_NE(std::system((handProgram().string() + " 2>/dev/null").c_str()), 0) << "nobody starts it by hand";
    EXPECT_NE(std::system((handProgram().string() + " pen right 1000 1 '' 2>/dev/null").c_str()), 0);
}

TEST(HandArguments, AreReadBack) {
    const HandArguments arguments{"pen:Left hand", true, 500, "/tmp/log.csv", 42};
    const auto back = HandArguments::from(arguments.words("tactooth-hand"));
    ASSERT_TRUE(back);
    EXPECT_EQ(back->device, arguments.device);
    EXPECT_TRUE(back->leftHanded);
    EXPECT_EQ(back->rateHz, 500);
    EXPECT_EQ(back->faultLog, arguments.faultLog);
    EXPECT_EQ(back->program, 42);
    for (const char* rate : {"0", "-1", "nan", "1e9", "fast", ""}) {
        EXPECT_FALSE(HandArguments::from({"hand", "pen", "left", rate, "42", ""})) << rate;
    }
    EXPECT_FALSE(HandArguments::from({"hand", "pen", "both", "1000", "42", ""}));
    EXPECT_FALSE(HandArguments::from({"hand", "pen", "left", "1000", "0", ""}));
    EXPECT_FALSE(HandArguments::from({"hand"}));
}

TEST(DeviceHost, IsTheHandProcessUnlessSomebodyAsksForThisOne) {
    {
        const test::ScopedVariable usual("TACTOOTH_DEVICE_IN_PROCESS", std::nullopt);
        EXPECT_EQ(deviceHost(), DeviceHost::HandProcess);
    }
    const test::ScopedVariable inProcess("TACTOOTH_DEVICE_IN_PROCESS", "1");
    EXPECT_EQ(deviceHost(), DeviceHost::ThisProcess);
}

}  // namespace
}  // namespace tactooth
