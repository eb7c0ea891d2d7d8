// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/model/progress_meter.h"

#include <gtest/gtest.h>

#include <chrono>

#include "session/block_with_cavity.h"
#include "session/simulation/cut_model.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

using namespace std::chrono_literals;

/// A block whose target has a cavity in its top. The test's clock stands still, and measurements run at once.
class ProgressMeterTest : public testing::Test {
protected:
    void SetUp() override { meter_.restart(metrics_); }
    void cut() {
        const CuttingTool bur{*RevolutionEnvelope::make(test::cylinder(Vec3::Zero(), 1, 5, 32)), 1};
        model_.sweep(bur, {Vec3(0, 0, 3), Quat::Identity()}, {Vec3(0.1 * ++cuts_, 0, 3), Quat::Identity()});
        model_.refreshSurface();
    }
    void update() { meter_.update(model_.surface(), total(model_.removed())); }

    std::shared_ptr<const LayeredTooth> tooth_ =
        std::make_shared<const LayeredTooth>(*LayeredTooth::make(test::box(Vec3(-5, -5, -5), Vec3(5, 5, 5))));
    CutModel model_{tooth_, 0.05};
    std::shared_ptr<CavityMetrics> metrics_ = std::make_shared<CavityMetrics>(
        std::make_shared<const SurfacePart>(test::blockWithCavity(Vec3(-2, -2, 3), Vec3(2, 2, 5))), *tooth_->outer());
    int cuts_ = 0;
    int measurements_ = 0;
    std::chrono::steady_clock::time_point now_{};
    ProgressMeter meter_{[this](const std::function<void()>& work) {
                             ++measurements_;
                             work();
                             return std::jthread();
                         },
                         [this] { return now_; }};
};

TEST_F(ProgressMeterTest, HasNoResultBeforeTheFirstMeasurement) {
    EXPECT_FALSE(meter_.progress());
    update();
    EXPECT_EQ(measurements_, 1);
    EXPECT_FALSE(meter_.progress()) << "the next step fetches it";
    update();
    ASSERT_TRUE(meter_.progress());
    EXPECT_EQ(meter_.progress()->cleared, 0);
}

TEST_F(ProgressMeterTest, MeasuresAgainOnlyAfterACut) {
    update();
    now_ += 10s;
    update();
    EXPECT_EQ(measurements_, 1);
    cut();
    update();
    update();
    EXPECT_EQ(measurements_, 2);
    EXPECT_GT(meter_.progress()->cleared, 5);
}

TEST_F(ProgressMeterTest, KeepsTheIntervalBetweenMeasurements) {
    update();
    cut();
    now_ += ProgressMeter::kInterval - 1ms;
    update();
    EXPECT_EQ(measurements_, 1);
    now_ += 1ms;
    update();
    EXPECT_EQ(measurements_, 2);
}

TEST_F(ProgressMeterTest, WithoutATargetNothingIsMeasured) {
    update();
    update();
    ASSERT_TRUE(meter_.progress());
    meter_.restart(nullptr);
    EXPECT_FALSE(meter_.progress());
    cut();
    now_ += 10s;
    update();
    EXPECT_EQ(measurements_, 1);
}

TEST_F(ProgressMeterTest, ARestartDropsAResultThatIsUnderWay) {
    cut();
    update();
    meter_.restart(nullptr);
    update();
    EXPECT_FALSE(meter_.progress());
}

TEST_F(ProgressMeterTest, WithoutAToothNothingIsMeasured) {
    meter_.update(nullptr, 0);
    EXPECT_EQ(measurements_, 0);
}

}  // namespace
}  // namespace tactooth
