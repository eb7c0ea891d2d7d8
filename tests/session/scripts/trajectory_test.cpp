// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/scripts/trajectory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

using ::testing::HasSubstr;

Expected<std::vector<TimedPose>> read(std::string_view text) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "path.csv", text);
    return readTrajectory(folder / "path.csv");
}

std::string refusal(std::string_view text) {
    const auto trajectory = read(text);
    return trajectory ? "accepted" : trajectory.error().message();
}

TEST(Trajectory, ReadsTimesPositionsAndRotations) {
    const auto trajectory = read("t,x,y,z,qw,qx,qy,qz\n0,1,2,3,1,0,0,0\n0.5,4,5,6,0.6,0,0.8,0\n");
    ASSERT_TRUE(trajectory) << trajectory.error().message();
    ASSERT_EQ(trajectory->size(), 2U);
    EXPECT_EQ((*trajectory)[0].toolInTooth.position, Vec3(1, 2, 3));
    EXPECT_EQ((*trajectory)[1].time, 0.5);
    EXPECT_TRUE((*trajectory)[1].toolInTooth.rotation.isApprox(Quat(0.6, 0, 0.8, 0), 1e-15));
}

TEST(Trajectory, AQuaternionOfFewDigitsIsMadeUnit) {
    const auto trajectory = read("t,x,y,z,qw,qx,qy,qz\n0,0,0,0,0.707,0,0.707,0\n");
    ASSERT_TRUE(trajectory);
    EXPECT_NEAR((*trajectory)[0].toolInTooth.rotation.norm(), 1, 1e-15);
}

TEST(Trajectory, RefusesAQuaternionThatIsNotUnit) {
    EXPECT_THAT(
        refusal("t,x,y,z,qw,qx,qy,qz\n0,0,0,0,1,0,0,0\n1,0,0,0,0,0,0,0\n"),
        HasSubstr("path.csv, line 3: the quaternion qw,qx,qy,qz must have length 1, but its length is 0; write"));
    EXPECT_THAT(refusal("t,x,y,z,qw,qx,qy,qz\n0,0,0,0,1e200,0,1e200,0\n"), HasSubstr("line 2: the quaternion"));
}

TEST(Trajectory, RefusesATimeThatRunsBackwardsButNotAPause) {
    EXPECT_THAT(refusal("t,x,y,z,qw,qx,qy,qz\n1,0,0,0,1,0,0,0\n0.9,0,0,0,1,0,0,0\n"),
                HasSubstr("line 3: time runs backwards"));
    EXPECT_EQ(refusal("t,x,y,z,qw,qx,qy,qz\n1,0,0,0,1,0,0,0\n1,0,0,0,1,0,0,0\n"), "accepted");
}

TEST(Trajectory, RefusesWhatIsNoTable) {
    EXPECT_THAT(refusal("t,x,y,z\n0,0,0,0\n"), HasSubstr("the column 'qw' is missing"));
    const test::TemporaryFolder folder;
    EXPECT_THAT(readTrajectory(folder / "none.csv").error().message(), HasSubstr("there is no such file"));
}

TEST(Trajectory, RefusesPlacesAndTimesThatNobodyMeans) {
    for (const std::string place : {"1e300,0,0", "0,-1e5,0", "0,0,10001", "1e154,1e154,1e154", "-1.7e308,0,0"}) {
        EXPECT_THAT(refusal("t,x,y,z,qw,qx,qy,qz\n0,0,0,0,1,0,0,0\n1," + place + ",1,0,0,0\n"),
                    HasSubstr("line 3: the tool is farther than 10 m from the tooth's origin"));
    }
    for (const std::string time : {"1e13", "-1e300", "1.7e308"}) {
        EXPECT_THAT(refusal("t,x,y,z,qw,qx,qy,qz\n" + time + ",0,0,0,1,0,0,0\n"), HasSubstr("line 2: t is too large"));
    }
    EXPECT_TRUE(read("t,x,y,z,qw,qx,qy,qz\n1764000000.123,1e4,0,0,1,0,0,0\n"));
}

}  // namespace
}  // namespace tactooth
