// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/cause/removal_moment.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "assessment/cause/removal_cause.h"
#include "assessment/cause/two_holes.h"
#include "assessment/ideal_shape.h"
#include "collision/bvh/closest_point.h"
#include "session/control/surface_ray.h"
#include "session/recording/session_replay.h"
#include "session/track/track_tooth.h"

namespace tactooth {
namespace {

using test::TwoHoles;

constexpr double kStartOfHole = 0.3;  // s: the ideal has this much of the first hole

std::shared_ptr<const SurfacePart> toothAt(const std::shared_ptr<const SessionTrack>& track, std::uint64_t moment) {
    TrackTooth tooth(track);
    tooth.moveTo(moment);
    return std::make_shared<const SurfacePart>(asReadFromFile(*tooth.model().surface()));
}

/// The ideal preparation is the beginning of the first hole, so that both holes are too deep.
class RemovalMomentTest : public testing::Test {
protected:
    void SetUp() override {
        session_ = TwoHoles::recorded();
        ASSERT_NE(session_, nullptr);
        const auto& track = session_->track();
        preparation_.original = toothAt(track, 0);
        preparation_.prepared = toothAt(track, track->ticks());
        preparation_.ideal = toothAt(track, track->momentAt(TwoHoles::kFirstHole + kStartOfHole));
        const PreparationMeasures measures(preparation_, {.student = track});
        results_ = measureAll(measures);
        errors_ = traceErrors(results_, preparation_, measures, track);
    }

    [[nodiscard]] const Measured& measured(std::string_view id) const {
        return std::ranges::find(results_, id, [](const MetricResult& each) { return each.metric->id; })->measured;
    }
    /// Depth of the surface below z = 1 over a square around `place`, as a replay of the recording has it at `time`.
    [[nodiscard]] std::vector<double> picture(double time, const Vec3& place) const {
        auto replay = SessionReplay::start(session_->recording());
        if (!replay || !replay->playUntil(time, [](double, const Tick&) {})) return {};
        const auto surface = replay->model().surface();
        std::vector<double> depths;
        for (int i = -kHalf; i <= kHalf; ++i) {
            for (int j = -kHalf; j <= kHalf; ++j) {
                const Vec3 from(place.x() + kPixel * i, place.y() + kPixel * j, 1);
                depths.push_back(firstHit(*surface, {from, -Vec3::UnitZ()}).value_or(0));
            }
        }
        return depths;
    }
    static constexpr int kHalf = 5;
    static constexpr double kPixel = 0.02;  // mm

    const TwoHoles* session_ = nullptr;
    Preparation preparation_;
    std::vector<MetricResult> results_;
    std::vector<OverPreparation> errors_;
};

TEST_F(RemovalMomentTest, GivesEachErrorPatchACauseOfItsOwn) {
    ASSERT_EQ(errors_.size(), 2U);
    for (const OverPreparation& error : errors_) {
        const bool isSecond = error.place.x() > 0;
        const double began = isSecond ? TwoHoles::kSecondHole : TwoHoles::kFirstHole;
        ASSERT_TRUE(error.cause && error.moment && error.cause->tilt);
        EXPECT_GE(error.cause->from, began);
        EXPECT_LE(error.cause->to, began + 1.1);
        EXPECT_GE(*error.moment, error.cause->from - kCauseStep);
        EXPECT_LE(*error.moment, error.cause->to + kCauseStep);
        EXPECT_NEAR(*error.cause->tilt, isSecond ? TwoHoles::kTilt * 180 / std::numbers::pi : 0, 0.1);
    }
    EXPECT_LT(errors_[0].place.x() * errors_[1].place.x(), 0) << "one in each hole";
    EXPECT_GE(errors_[0].volume, errors_[1].volume);
}

/// Sound before the range that is named, and cut behind it.
TEST_F(RemovalMomentTest, ReplayedToTheMomentOfTheLargestOverPreparationShowsIt) {
    ASSERT_FALSE(errors_.empty());
    const OverPreparation& error = errors_.front();
    const Vec3 removed = error.place + 0.06 * Vec3::UnitZ();
    const std::vector<double> before = picture(error.cause->from - 0.1, error.place);
    const std::vector<double> after = picture(error.cause->to + 0.1, error.place);
    ASSERT_EQ(before.size(), after.size());
    ASSERT_FALSE(before.empty());
    const std::size_t middle = before.size() / 2;
    EXPECT_LT(before[middle], 1 - removed.z()) << "the material is still there";
    EXPECT_GT(after[middle], 1 - removed.z()) << "it is gone";
    EXPECT_NEAR(after[middle], 1 - error.place.z(), 0.1);
    const std::vector<double> atLast = picture(error.cause->to + 0.3, error.place);
    EXPECT_NEAR(atLast[middle], after[middle], 0.02) << "later work has not made it";
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_GE(after[i], before[i] - 1e-6);
}

TEST_F(RemovalMomentTest, TheMomentOfAPlaceIsWhenItGoes) {
    const Measured& deepest = measured("over_max");
    ASSERT_TRUE(deepest.moment && deepest.place);
    const auto& track = session_->track();
    const std::uint64_t moment = track->momentAt(*deepest.moment);
    constexpr std::uint64_t kNear =
        40;  // ticks: the material is looked for square to the floor, which is not quite level
    const Vec3 removed = *deepest.place + 0.06 * Vec3::UnitZ();
    TrackTooth tooth(track);
    tooth.moveTo(moment + kNear);
    EXPECT_LT(tooth.model().volume().cutDistance(removed), 0);
    tooth.moveTo(moment - kNear);
    EXPECT_GE(tooth.model().volume().cutDistance(removed), 0);
}

TEST_F(RemovalMomentTest, EachValueOfWhatWasRemovedHasPlaceAndMoment) {
    for (const char* id :
         {"over_max", "over_volume", "deviation_rms", "within_0_1", "dice", "extent_md", "extent_og"}) {
        SCOPED_TRACE(id);
        ASSERT_TRUE(measured(id).value);
        EXPECT_TRUE(measured(id).place);
        EXPECT_TRUE(measured(id).moment);
        EXPECT_TRUE(measured(id).cause);
    }
    EXPECT_FALSE(measured("under_volume").moment) << "nobody has removed what is left";
    EXPECT_FALSE(measured("decay_left").place);
    EXPECT_FALSE(measured("path_length").moment) << "the whole session";
    EXPECT_TRUE(*measured("over_volume").place == errors_.front().place) << "the largest patch";
}

TEST_F(RemovalMomentTest, WithoutASessionThereArePlacesOnly) {
    const PreparationMeasures measures(preparation_);
    std::vector<MetricResult> results = measureAll(measures);
    const auto errors = traceErrors(results, preparation_, measures, nullptr);
    ASSERT_EQ(errors.size(), 2U);
    EXPECT_TRUE(errors[0].place == errors_[0].place);
    EXPECT_FALSE(errors[0].moment);
    EXPECT_FALSE(errors[0].cause);
    for (std::size_t i = 0; i < results.size(); ++i) {
        EXPECT_TRUE(results[i].measured.place == results_[i].measured.place);
        EXPECT_FALSE(results[i].measured.moment);
    }
}

}  // namespace
}  // namespace tactooth
