// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/simulation/work_liquids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tactooth {
namespace {

const Vec3 kOpening(0.5, -0.5, 2);

SprayInput spraying(double water, double ground = 0) {
    SprayInput now;
    now.toolInTooth.position = Vec3(1, 2, 3);
    now.water = water;
    now.ground[0] = ground;
    return now;
}

TEST(WorkLiquids, TheFilmGrowsToTheFlowAndDriesInItsTimeWhateverTheStep) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> step(0.001, 0.05);
    WorkLiquids liquids;
    double time = 0;
    while (time < 0.3) {
        const double dt = step(random);
        liquids.advance(spraying(0.8), std::nullopt, dt);
        time += dt;
    }
    EXPECT_NEAR(liquids.water(), 0.8 * (1 - std::exp(-time / WorkLiquids::kWets)), 1e-9);
    EXPECT_EQ(liquids.spot(), Vec3(1, 2, 3));
    const double before = liquids.water();
    for (int i = 0; i < 10; ++i) liquids.advance(spraying(0), std::nullopt, 0.1);
    EXPECT_NEAR(liquids.water(), before - 1 / WorkLiquids::kDries, 1e-9);
    for (int i = 0; i < 20; ++i) liquids.advance(spraying(0), std::nullopt, 0.1);
    EXPECT_EQ(liquids.water(), 0);
}

TEST(WorkLiquids, WhatIsGroundOffMakesWaterMilkyAndTheSprayRinsesIt) {
    WorkLiquids liquids;
    liquids.advance(spraying(1, 5), std::nullopt, 0.01);
    EXPECT_EQ(liquids.slurry(), 0) << "cut before";
    liquids.advance(spraying(1, 5 + WorkLiquids::kMilky), std::nullopt, 0.01);
    EXPECT_NEAR(liquids.slurry(), 1 - std::exp(-1.0), 1e-9);
    const double milky = liquids.slurry();
    liquids.advance(spraying(1, 5), std::nullopt, WorkLiquids::kRinses);  // an undo
    EXPECT_NEAR(liquids.slurry(), milky * std::exp(-1.0), 1e-9);
}

TEST(WorkLiquids, DustMakesNoSlurry) {
    WorkLiquids liquids;
    for (int i = 0; i < 10; ++i) liquids.advance(spraying(0, i), std::nullopt, 0.01);
    EXPECT_EQ(liquids.slurry(), 0);
    EXPECT_EQ(liquids.water(), 0);
}

TEST(WorkLiquids, BloodSpreadsToItsReachAndIsWashedAway) {
    WorkLiquids liquids;
    double last = 0;
    for (int i = 1; i <= 100; ++i) {
        liquids.advance(spraying(0), kOpening, 0.05);
        EXPECT_GT(liquids.blood(), last);
        last = liquids.blood();
        EXPECT_NEAR(last, WorkLiquids::kBloodReach * (1 - std::exp(-0.05 * i / WorkLiquids::kBleeds)), 1e-9);
    }
    EXPECT_LT(last, WorkLiquids::kBloodReach);
    EXPECT_EQ(liquids.opening(), kOpening);
    liquids.advance(spraying(1), kOpening, WorkLiquids::kWashes);
    EXPECT_NEAR(liquids.blood(), last * std::exp(-1.0), 1e-9);
    liquids.advance(spraying(0), kOpening, 0.05);
    EXPECT_GT(liquids.blood(), last * std::exp(-1.0)) << "it wells up again";
    liquids.advance(spraying(0), std::nullopt, 0.05);
    EXPECT_EQ(liquids.blood(), 0) << "the cut was taken back";
}

}  // namespace
}  // namespace tactooth
