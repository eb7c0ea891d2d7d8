// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/spacemouse/space_mouse_device.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <thread>
#include <utility>

#include "standin/standin_spacenavd.h"
#include "support/test_data.h"

// libspnav 1.0 does not free its event list if no driver answers. The leak sanitizer reads this function.
extern "C" const char* __lsan_default_suppressions();  // NOLINT(bugprone-reserved-identifier): the sanitizer's name
extern "C" const char* __lsan_default_suppressions() { return "leak:spnav_open\n"; }

namespace tactooth {
namespace {

using namespace std::chrono_literals;
using test::StandinSpacenavd;
using ::testing::HasSubstr;

template <class Done>
bool playUntil(HapticDevice& device, const Done& done) {
    for (int i = 0; i < 60'000; ++i) {
        if (done(device.read(0.001))) return true;
        std::this_thread::sleep_for(1ms);
    }
    return false;
}

class SpaceMouse : public ::testing::Test {
protected:
    void SetUp() override { setenv("SPNAV_SOCKET", socket_.c_str(), 1); }
    void TearDown() override { unsetenv("SPNAV_SOCKET"); }

    test::TemporaryFolder folder_;
    std::string socket_ = (folder_ / "spnav.sock").string();
};

TEST_F(SpaceMouse, WithoutItsDriverItSaysWhatToDo) {
    SpaceMouseDevice device;
    const auto opened = device.open();
    ASSERT_FALSE(opened);
    EXPECT_THAT(opened.error().message(), HasSubstr("install spacenavd, start it"));
}

TEST_F(SpaceMouse, ItsAxesAreSpeeds) {
    SpaceMouseState state;
    state.axes = {350, 0, 0, 0, 0, 0};
    EXPECT_NEAR(rateCommand(state).speed.x(), 25, 1e-9) << "right";
    state.axes = {0, -350, 0, 0, 0, 0};
    EXPECT_NEAR(rateCommand(state).speed.z(), -25, 1e-9) << "pushed down";
    state.axes = {0, 0, 700, 0, 0, 0};
    EXPECT_NEAR(rateCommand(state).speed.y(), 25, 1e-9) << "away, and never faster";
    state.axes = {10, -10, 17, 10, 10, 10};
    EXPECT_EQ(rateCommand(state).speed, Vec3::Zero()) << "dead zone";
    EXPECT_EQ(rateCommand(state).turn, Vec3::Zero());
    state.axes = {0, 0, 0, 0, 350, 0};
    EXPECT_NEAR(rateCommand(state).turn.z(), 1.2, 1e-9) << "turned about the upright";
}

TEST_F(SpaceMouse, TheCapMovesAndTurnsTheTool) {
    StandinSpacenavd driver(socket_);
    SpaceMouseDevice device;
    ASSERT_TRUE(device.open());
    ASSERT_TRUE(driver.move({300, 0, 0, 0, 0, 0}));
    EXPECT_TRUE(playUntil(device, [](const DeviceSample& s) { return s.hand.position.x() > 3; }));
    ASSERT_TRUE(driver.move({0, -300, 0, 0, 200, 0}));
    EXPECT_TRUE(playUntil(device, [](const DeviceSample& s) {
        return s.hand.position.z() < -3 && Eigen::AngleAxisd(s.hand.rotation).angle() > 0.1;
    }));
    ASSERT_TRUE(driver.move({}));
    Vec3 last = Vec3::Zero();
    EXPECT_TRUE(playUntil(device, [&](const DeviceSample& s) {
        return (std::exchange(last, s.hand.position) - s.hand.position).norm() < 1e-9;
    }));
    EXPECT_EQ(device.faultMessage(), nullptr);
}

TEST_F(SpaceMouse, ButtonsComeThrough) {
    StandinSpacenavd driver(socket_);
    SpaceMouseDevice device;
    ASSERT_TRUE(device.open());
    ASSERT_TRUE(driver.button(1, true));
    EXPECT_TRUE(playUntil(device, [](const DeviceSample& s) { return s.buttons == 2U; }));
    ASSERT_TRUE(driver.button(0, true));
    EXPECT_TRUE(playUntil(device, [](const DeviceSample& s) { return s.buttons == 3U; }));
    ASSERT_TRUE(driver.button(1, false));
    EXPECT_TRUE(playUntil(device, [](const DeviceSample& s) { return s.buttons == 1U; }));
}

TEST_F(SpaceMouse, ADriverThatStopsMeansLostAndOneThatStartsAgainIsFound) {
    auto driver = std::make_unique<StandinSpacenavd>(socket_);
    SpaceMouseDevice device;
    ASSERT_TRUE(device.open());
    ASSERT_TRUE(driver->move({300, 0, 0, 0, 0, 0}));
    EXPECT_TRUE(playUntil(device, [](const DeviceSample& s) { return s.hand.position.x() > 1; }));
    driver.reset();
    EXPECT_TRUE(playUntil(device, [](const DeviceSample& s) { return !s.connected; }));
    ASSERT_NE(device.faultMessage(), nullptr);
    EXPECT_THAT(device.faultMessage()->in(Language::English), HasSubstr("start it again"));
    driver = std::make_unique<StandinSpacenavd>(socket_);
    EXPECT_TRUE(playUntil(device, [](const DeviceSample& s) { return s.connected; }));
    EXPECT_EQ(device.faultMessage(), nullptr);
}

TEST_F(SpaceMouse, OnlyOneSteers) {
    StandinSpacenavd driver(socket_);
    SpaceMouseDevice device, other;
    ASSERT_TRUE(device.open());
    EXPECT_FALSE(other.open());
    device.close();
    EXPECT_TRUE(other.open());
}

}  // namespace
}  // namespace tactooth
