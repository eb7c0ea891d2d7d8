// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/scripts/replay_device.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "devices/open_device.h"
#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

using ::testing::HasSubstr;

Expected<std::unique_ptr<HapticDevice>> replay(std::string_view text) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "path.csv", text);
    return openDeviceOrReplay("replay:" + (folder / "path.csv").string());
}

TEST(ReplayDevice, FollowsThePathOfTheFileAndRestsAtItsEnd) {
    const auto hand = replay("t,x,y,z,qw,qx,qy,qz\n0,1,2,3,1,0,0,0\n0.5,4,2,3,0.6,0,0.8,0\n");
    ASSERT_TRUE(hand) << hand.error().message();
    EXPECT_EQ((*hand)->info().name, "path.csv");
    EXPECT_TRUE((*hand)->info().isInToothFrame);
    EXPECT_EQ((*hand)->read(0.25).hand.position, Vec3(2.5, 2, 3));
    const DeviceSample last = (*hand)->read(10);
    EXPECT_EQ(last.hand.position, Vec3(4, 2, 3));
    EXPECT_NEAR(last.hand.rotation.y(), 0.8, 1e-12);
    EXPECT_TRUE(last.connected);
}

TEST(ReplayDevice, SaysWhatIsWrongWithTheFile) {
    EXPECT_THAT(openDeviceOrReplay("replay:/no/such.csv").error().message(),
                HasSubstr("/no/such.csv: there is no such file"));
    EXPECT_THAT(replay("t,x,y,z,qw,qx,qy,qz\n").error().message(), HasSubstr("path.csv"));
    EXPECT_THAT(replay("t,x,y,z,qw,qx,qy,qz\n0,a,2,3,1,0,0,0\n").error().message(), HasSubstr("line 2"));
}

TEST(ReplayDevice, OtherNamesAreThoseOfDevices) {
    EXPECT_THAT(openDeviceOrReplay("replay:").error().message(), HasSubstr("replay:FILE.csv"));
    EXPECT_TRUE(checkDeviceName("replay:path.csv", "--device"));
    EXPECT_FALSE(checkDeviceName("replay:", "--device"));
}

}  // namespace
}  // namespace tactooth
