// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/cause/removal_cause.h"

#include <gtest/gtest.h>

#include <numbers>

#include "assessment/cause/two_holes.h"

namespace tactooth {
namespace {

using test::TwoHoles;
constexpr double kTilt = TwoHoles::kTilt, kSecondHole = TwoHoles::kSecondHole;

class RemovalCauseTest : public testing::Test {
protected:
    void SetUp() override {
        const TwoHoles* session = TwoHoles::recorded();
        ASSERT_NE(session, nullptr);
        track_ = session->track();
    }
    /// Points in a hole, 0.05 to 0.3 mm deep.
    static std::vector<RemovedPoint> pointsAt(double x, double size = 1) {
        std::vector<RemovedPoint> points;
        for (double z = -0.05; z > -0.3; z -= 0.05) points.push_back({Vec3(x, 0, z), size});
        return points;
    }

    std::shared_ptr<const SessionTrack> track_;
};

TEST_F(RemovalCauseTest, FindsWhenEachPointWentAway) {
    TrackTooth tooth(track_);
    const std::vector<RemovedPoint> points = pointsAt(-1);
    const auto times = removalTimes(*track_, tooth, points);
    double last = 1;
    for (const auto& time : times) {
        ASSERT_TRUE(time);
        EXPECT_GE(*time, last - kCauseStep) << "deeper points go later";
        EXPECT_LT(*time, 2.1);
        last = *time;
    }
    const auto others = removalTimes(*track_, tooth, {{Vec3(0, 1.5, -0.1), 1}, {Vec3(-1, 0, 0.5), 1}});
    EXPECT_FALSE(others[0]) << "nobody has cut there";
    EXPECT_FALSE(others[1]) << "there was never any tooth";
}

TEST_F(RemovalCauseTest, IsThePieceOfWorkThatRemovedMost) {
    TrackTooth tooth(track_);
    std::vector<RemovedPoint> points = pointsAt(-1, 1), more = pointsAt(1, 3);
    points.insert(points.end(), more.begin(), more.end());
    const auto cause = removalCauses(*track_, tooth, {points}, Vec3::UnitZ()).front();
    ASSERT_TRUE(cause);
    EXPECT_GE(cause->from, kSecondHole);
    EXPECT_LE(cause->to, kSecondHole + 1.1);
    EXPECT_LT(cause->from, cause->to);
    ASSERT_TRUE(cause->tilt);
    EXPECT_NEAR(*cause->tilt, kTilt * 180 / std::numbers::pi, 0.1);
    EXPECT_GT(cause->force, 0.05);
    EXPECT_LT(cause->force, 3);
}

TEST_F(RemovalCauseTest, OfAnUprightBurHasNoTilt) {
    TrackTooth tooth(track_);
    const auto cause = removalCauses(*track_, tooth, {pointsAt(-1)}, Vec3::UnitZ()).front();
    ASSERT_TRUE(cause);
    EXPECT_NEAR(cause->tilt.value_or(90), 0, 0.1);
    EXPECT_LT(cause->to, 2.1);
    const std::vector<RemovedPoint> none, kept = {{Vec3(0, 1.5, -0.1), 1}};
    for (const auto& each : removalCauses(*track_, tooth, {none, kept}, Vec3::UnitZ())) EXPECT_FALSE(each);
}

}  // namespace
}  // namespace tactooth
