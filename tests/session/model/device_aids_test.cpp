// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/device_aids.h"

#include <gtest/gtest.h>

#include "model/model_scene.h"

namespace tactooth {
namespace {

/// With a stop and a guide that are on.
class DeviceAidsTest : public testing::Test {
protected:
    DeviceAidsTest() {
        aids_.setDepthStop(true);
        aids_.setGuide(true);
        depth_.setDepth(1.25);
    }
    [[nodiscard]] SessionControls given() const {
        SessionControls controls;
        aids_.addTo(controls, depth_);
        return controls;
    }

    const std::shared_ptr<const DistanceGrid> walls_ = std::make_shared<const DistanceGrid>(
        guideWalls(*test::blockOnTheBench()->surface()->base, Box3(Vec3(-1, -1, -2), Vec3(1, 1, 0))));
    DepthControl depth_;
    DeviceAids aids_;
};

TEST_F(DeviceAidsTest, WithoutABurThereIsNone) {
    aids_.setWalls(walls_);
    EXPECT_EQ(given().depthStop, nullptr);
    EXPECT_EQ(given().guide, nullptr);
}

TEST_F(DeviceAidsTest, AHandInstrumentGetsNone) {
    aids_.setWalls(walls_);
    aids_.setBur(test::flatSessionBur());
    ASSERT_NE(given().guide, nullptr);
    aids_.setBur(makeHandInstrument(HandInstrument::Explorer));
    EXPECT_EQ(given().depthStop, nullptr);
    EXPECT_EQ(given().guide, nullptr);
}

TEST_F(DeviceAidsTest, TheStopIsAtTheDepthOfTheMouse) {
    aids_.setBur(test::flatSessionBur());
    ASSERT_NE(given().depthStop, nullptr);
    EXPECT_EQ(given().depthStop->depth(), 1.25);
    EXPECT_EQ(given().guide, nullptr) << "there are no walls";
    aids_.setDepthStop(false);
    EXPECT_EQ(given().depthStop, nullptr);
}

TEST_F(DeviceAidsTest, TheGuideFollowsBurAndWalls) {
    aids_.setBur(test::flatSessionBur());
    aids_.setWalls(walls_);
    const auto first = given().guide;
    ASSERT_NE(first, nullptr);
    EXPECT_EQ(given().guide, first) << "it is made once";
    EXPECT_GT(first->push({Vec3(0, 0, -0.3), Quat::Identity()}).force.z(), 0) << "the bur is in the block";
    aids_.setBur(test::flatSessionBur());
    EXPECT_NE(given().guide, first);
    aids_.setGuide(false);
    EXPECT_EQ(given().guide, nullptr);
    aids_.setGuide(true);
    aids_.setWalls(nullptr);
    EXPECT_EQ(given().guide, nullptr);
}

}  // namespace
}  // namespace tactooth
