// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/cavity_account.h"

#include <gtest/gtest.h>

#include <numbers>

#include "session/block_with_cavity.h"
#include "session/simulation/work_piece.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

constexpr double kRadius = 1;  // mm, of the bur

class CavityAccountTest : public ::testing::Test {
protected:
    /// A round hole down to `floor` from x = `from` to `to`.
    void cut(double from, double to, double floor = 3) {
        const CuttingTool bur{*RevolutionEnvelope::make(test::cylinder(Vec3::Zero(), kRadius, 5, 96)), 1};
        piece_.sweep(bur, {Vec3(from, 0, floor), Quat::Identity()}, {Vec3(to, 0, floor), Quat::Identity()});
        piece_.refreshSurface();
    }
    CavityProgress progress(CavityAccount& account) const {
        return account.of(*piece_.surface(), total(piece_.removed()));
    }
    static CavityAccount accountOf(const TriangleMesh& target, const SurfacePart& outer) {
        return {std::make_shared<const SurfacePart>(target), outer};
    }

    std::shared_ptr<const LayeredTooth> tooth_ =
        std::make_shared<const LayeredTooth>(*LayeredTooth::make(test::box(Vec3(-5, -5, -5), Vec3(5, 5, 5))));
    TriangleMesh target_ = test::blockWithCavity(Vec3(-2, -2, 3), Vec3(2, 2, 5));  // 32 mm^3
    CavityAccount account_ = accountOf(target_, *tooth_->outer());
    WorkPiece piece_{tooth_, 0.05};
};

TEST_F(CavityAccountTest, ADeeperOrWiderCavityIsAsLargeAsItIs) {
    EXPECT_NEAR(progress(account_).planned, 32, 0.32);
    for (const double floor : {4.5, 3.03, 1.77}) {  // wherever the floor lies between two points
        CavityAccount account =
            accountOf(test::blockWithCavity(Vec3(-1, -2, floor), Vec3(2, 1.5, 5)), *tooth_->outer());
        const double volume = 3 * 3.5 * (5 - floor);
        EXPECT_NEAR(progress(account).planned, volume, 0.01 * volume) << floor;
    }
}

TEST_F(CavityAccountTest, NothingIsDoneToAWholeTooth) {
    const CavityProgress none = progress(account_);
    EXPECT_EQ(none.cleared, 0);
    EXPECT_EQ(none.beyond, 0);
    EXPECT_EQ(none.deepest, 0);
    EXPECT_EQ(none.likeness(), 0);
    EXPECT_FALSE(account_.empty());
}

TEST_F(CavityAccountTest, ATargetThatIsTheToothItselfHasNothingToCut) {
    CavityAccount account = accountOf(tooth_->outer()->mesh(), *tooth_->outer());
    EXPECT_TRUE(account.empty());
    cut(0, 0);
    const CavityProgress all = progress(account);
    EXPECT_EQ(all.planned, 0);
    EXPECT_EQ(all.clearedShare(), 0);
    EXPECT_NEAR(all.beyond, std::numbers::pi * 2, 0.05);
    EXPECT_NEAR(all.deepest, 2, 0.01);  // below the top of the block
}

TEST_F(CavityAccountTest, ACutWithinTheCavityIsAllCleared) {
    cut(-0.5, 0.5);
    const CavityProgress part = progress(account_);
    const double volume = 2 * (std::numbers::pi + 2);  // the floor lies on the cavity's
    EXPECT_NEAR(part.cleared, volume, 0.1);
    EXPECT_LT(part.beyond, 0.1);
    EXPECT_LT(part.deepest, 0.01);
    EXPECT_NEAR(part.clearedShare(), volume / 32, 0.01);
    EXPECT_NEAR(part.likeness(), 2 * volume / (32 + volume), 0.01);
}

TEST_F(CavityAccountTest, WhatIsCutTooDeepIsBeyond) {
    cut(0, 0, 2.6);
    const CavityProgress deep = progress(account_);
    EXPECT_NEAR(deep.cleared, std::numbers::pi * 2, 0.1);
    EXPECT_NEAR(deep.beyond, std::numbers::pi * 0.4, 0.1);
    EXPECT_NEAR(deep.deepest, 0.4, 0.01);
}

TEST_F(CavityAccountTest, WhatIsCutTooWideIsBeyond) {
    cut(1.5, 1.5);
    EXPECT_NEAR(progress(account_).deepest, 0.5, 0.01);
    EXPECT_GT(progress(account_).beyond, 0.5);
}

TEST_F(CavityAccountTest, TakingBackTakesItAllBack) {
    piece_.mark();
    cut(0, 1.5, 2.5);
    EXPECT_GT(progress(account_).deepest, 0.4);
    ASSERT_TRUE(piece_.undo());
    const CavityProgress none = progress(account_);
    EXPECT_EQ(none.cleared, 0);
    EXPECT_EQ(none.beyond, 0);
    EXPECT_EQ(none.deepest, 0);
}

TEST_F(CavityAccountTest, StepByStepIsTheSameAsAtOnce) {
    const std::array<std::pair<double, double>, 3> ways = {{{-1, -0.8}, {-0.8, 0.5}, {1, 0.9}}};
    for (const auto& [from, to] : ways) {
        cut(from, to, 3.2 - 0.3 * from);
        CavityAccount fresh = accountOf(target_, *tooth_->outer());
        const CavityProgress now = progress(account_), anew = progress(fresh);
        EXPECT_EQ(now.cleared, anew.cleared);
        EXPECT_EQ(now.beyond, anew.beyond);
        EXPECT_EQ(now.deepest, anew.deepest);
    }
}

}  // namespace
}  // namespace tactooth
