// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/cavity_metrics.h"

#include <gtest/gtest.h>

#include <numbers>

#include "session/block_with_cavity.h"
#include "session/simulation/cut_model.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

constexpr double kRadius = 1;  // mm, of the bur

class CavityMetricsTest : public ::testing::Test {
protected:
    /// A round hole down to `floor` from x = `from` to `to`.
    void cut(double from, double to, double floor = 3) {
        const CuttingTool bur{*RevolutionEnvelope::make(test::cylinder(Vec3::Zero(), kRadius, 5, 96)), 1};
        model_.sweep(bur, {Vec3(from, 0, floor), Quat::Identity()}, {Vec3(to, 0, floor), Quat::Identity()});
        model_.refreshSurface();
    }
    CavityProgress progress(CavityMetrics& metrics) const {
        return metrics.of(*model_.surface(), total(model_.removed()));
    }
    static CavityMetrics metricsOf(const TriangleMesh& target, const SurfacePart& outer) {
        return {std::make_shared<const SurfacePart>(target), outer};
    }

    std::shared_ptr<const LayeredTooth> tooth_ =
        std::make_shared<const LayeredTooth>(*LayeredTooth::make(test::box(Vec3(-5, -5, -5), Vec3(5, 5, 5))));
    TriangleMesh target_ = test::blockWithCavity(Vec3(-2, -2, 3), Vec3(2, 2, 5));  // 32 mm^3
    CavityMetrics metrics_ = metricsOf(target_, *tooth_->outer());
    CutModel model_{tooth_, 0.05};
};

TEST_F(CavityMetricsTest, ADeeperOrWiderCavityIsAsLargeAsItIs) {
    EXPECT_NEAR(progress(metrics_).planned, 32, 0.32);
    for (const double floor : {4.5, 3.03, 1.77}) {  // at different positions between two points
        CavityMetrics metrics =
            metricsOf(test::blockWithCavity(Vec3(-1, -2, floor), Vec3(2, 1.5, 5)), *tooth_->outer());
        const double volume = 3 * 3.5 * (5 - floor);
        EXPECT_NEAR(progress(metrics).planned, volume, 0.01 * volume) << floor;
    }
}

TEST_F(CavityMetricsTest, NothingIsDoneToAWholeTooth) {
    const CavityProgress none = progress(metrics_);
    EXPECT_EQ(none.cleared, 0);
    EXPECT_EQ(none.beyond, 0);
    EXPECT_EQ(none.maxOverPreparation, 0);
    EXPECT_EQ(none.dice(), 0);
    EXPECT_FALSE(metrics_.empty());
}

TEST_F(CavityMetricsTest, ATargetThatIsTheToothItselfHasNothingToCut) {
    CavityMetrics metrics = metricsOf(tooth_->outer()->mesh(), *tooth_->outer());
    EXPECT_TRUE(metrics.empty());
    cut(0, 0);
    const CavityProgress all = progress(metrics);
    EXPECT_EQ(all.planned, 0);
    EXPECT_EQ(all.clearedFraction(), 0);
    EXPECT_NEAR(all.beyond, std::numbers::pi * 2, 0.05);
    EXPECT_NEAR(all.maxOverPreparation, 2, 0.01);  // below the top of the block
}

TEST_F(CavityMetricsTest, ACutWithinTheCavityIsAllCleared) {
    cut(-0.5, 0.5);
    const CavityProgress part = progress(metrics_);
    const double volume = 2 * (std::numbers::pi + 2);  // the floor lies on the cavity's
    EXPECT_NEAR(part.cleared, volume, 0.1);
    EXPECT_LT(part.beyond, 0.1);
    EXPECT_LT(part.maxOverPreparation, 0.01);
    EXPECT_NEAR(part.clearedFraction(), volume / 32, 0.01);
    EXPECT_NEAR(part.dice(), 2 * volume / (32 + volume), 0.01);
}

TEST_F(CavityMetricsTest, WhatIsCutTooDeepIsBeyond) {
    cut(0, 0, 2.6);
    const CavityProgress deep = progress(metrics_);
    EXPECT_NEAR(deep.cleared, std::numbers::pi * 2, 0.1);
    EXPECT_NEAR(deep.beyond, std::numbers::pi * 0.4, 0.1);
    EXPECT_NEAR(deep.maxOverPreparation, 0.4, 0.01);
}

TEST_F(CavityMetricsTest, WhatIsCutTooWideIsBeyond) {
    cut(1.5, 1.5);
    EXPECT_NEAR(progress(metrics_).maxOverPreparation, 0.5, 0.01);
    EXPECT_GT(progress(metrics_).beyond, 0.5);
}

TEST_F(CavityMetricsTest, TakingBackTakesItAllBack) {
    model_.mark(0);
    cut(0, 1.5, 2.5);
    EXPECT_GT(progress(metrics_).maxOverPreparation, 0.4);
    ASSERT_TRUE(model_.undo());
    const CavityProgress none = progress(metrics_);
    EXPECT_EQ(none.cleared, 0);
    EXPECT_EQ(none.beyond, 0);
    EXPECT_EQ(none.maxOverPreparation, 0);
}

TEST_F(CavityMetricsTest, StepByStepIsTheSameAsAtOnce) {
    const std::array<std::pair<double, double>, 3> strokes = {{{-1, -0.8}, {-0.8, 0.5}, {1, 0.9}}};
    for (const auto& [from, to] : strokes) {
        cut(from, to, 3.2 - 0.3 * from);
        CavityMetrics fresh = metricsOf(target_, *tooth_->outer());
        const CavityProgress now = progress(metrics_), anew = progress(fresh);
        EXPECT_EQ(now.cleared, anew.cleared);
        EXPECT_EQ(now.beyond, anew.beyond);
        EXPECT_EQ(now.maxOverPreparation, anew.maxOverPreparation);
    }
}

}  // namespace
}  // namespace tactooth
