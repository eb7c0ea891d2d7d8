// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/experiments.h"

#include <gtest/gtest.h>

#include <cmath>

#include "experiments/contact_timing.h"
#include "experiments/quantile.h"
#include "experiments/slot_timing.h"
#include "geometry/mesh/mesh_report.h"
#include "support/shapes.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

double number(const Cell& cell) { return std::get<double>(cell); }

TEST(Quantile, IsTheValueThatAShareDoesNotExceed) {
    std::vector<double> values;
    for (int i = 100; i >= 0; --i) values.push_back(i);
    EXPECT_EQ(quantile(values, 0.5), 50);
    EXPECT_EQ(quantile(values, 0.99), 99);
    EXPECT_EQ(quantile(values, 1), 100);
    std::vector<double> none;
    EXPECT_EQ(quantile(none, 0.5), 0);
}

TEST(StandardTeeth, LadderKeepsItsSharesAndTheToothClosed) {
    const TriangleMesh ball = test::sphere(Vec3::Zero(), 5, 60, 41);  // 4800 triangles
    const std::vector<Resolution> ladder = resolutionLadder(ball, kResolutions);
    ASSERT_EQ(ladder.size(), kResolutions.size());
    for (const Resolution& resolution : ladder) {
        const auto wanted = static_cast<double>(ball.triangles.size()) * resolution.percent / 100;
        EXPECT_NEAR(static_cast<double>(resolution.mesh.triangles.size()), wanted, 2);
        EXPECT_TRUE(reportOn(resolution.mesh).watertight());
    }
    EXPECT_EQ(ladder.back().mesh.triangles, ball.triangles);
}

TEST(StandardTeeth, EachHasANameASourceAndAClosedSurface) {
    for (const StandardToothKind kind :
         {StandardToothKind::Front, StandardToothKind::Molar, StandardToothKind::Canine}) {
        const auto tooth = standardTooth(kind);
        ASSERT_TRUE(tooth);
        EXPECT_FALSE(tooth->name.empty());
        EXPECT_FALSE(tooth->source.empty());
        EXPECT_TRUE(reportOn(tooth->mesh).closed());
    }
}

TEST(ContactTiming, CountsTheTicksInContact) {
    const TriangleMesh plate = test::box(Vec3(-9, -9, -5), Vec3(9, 9, 0));
    const auto ball = std::make_shared<const ToolShape>(test::sphere(Vec3(0, 0, 0.7), 0.7, 16, 8));
    const std::vector<Pose> hand = toolTrajectory(plate, standardToolPath(kFastSpeed));
    const ContactTiming timing = timeContact(plainSurface(plate), ball, hand, 2);
    EXPECT_EQ(timing.ticks, hand.size());
    EXPECT_GT(timing.inContact, timing.ticks / 2);
    EXPECT_LT(timing.inContact, timing.ticks);
    EXPECT_EQ(timing.overlapping, 0U);
    EXPECT_GE(timing.contacts, 1);
    EXPECT_GE(timing.iterations, 1);
    EXPECT_GT(timing.p50, 0);
    EXPECT_LE(timing.p50, timing.p99);
    EXPECT_LE(timing.p99, timing.p999);
    EXPECT_LE(timing.p999, timing.largest);
}

TEST(TenPatchesExperiment, ProxyIsExactUpToTheSpeedOfAHand) {
    const Experiment experiment = measureTenPatches(TestTeeth());
    ASSERT_EQ(experiment.rows.size(), 18U);
    for (const std::vector<Cell>& row : experiment.rows) {
        ASSERT_EQ(row.size(), experiment.columns.size());
        EXPECT_GT(number(row[3]), 0);  // ticks in contact
        if (number(row[1]) <= 100) {
            EXPECT_LT(number(row[5]), 0.01) << std::get<std::string>(row[0]) << " um";
        }
    }
    EXPECT_EQ(experiment.panels.size(), 4U);
}

TEST(SidewaysExperiment, ProxyStopsWhereTheHandGoesOn) {
    TestTeeth testTeeth;
    const auto experiment = measureSideways(testTeeth);
    ASSERT_TRUE(experiment);
    double deepest = 0, farthestApart = 0;
    for (const std::vector<Cell>& row : experiment->rows) {
        deepest = std::max(deepest, number(row[4]));
        farthestApart = std::max(farthestApart, number(row[2]) - number(row[3]));
        if (number(row[4]) == 0) {
            EXPECT_NEAR(number(row[2]), number(row[3]), 1e-9);
        }
    }
    EXPECT_GT(deepest, 0.2);
    EXPECT_LE(deepest, 0.5 + 0.02);
    EXPECT_GT(farthestApart, 0.1);
}

TEST(TouchExperiment, ForceComesWithDepthAtBothSpeeds) {
    TestTeeth testTeeth;
    const auto experiment = measureTouch(testTeeth, StandardToothKind::Front);
    ASSERT_TRUE(experiment);
    EXPECT_EQ(experiment->id, "fig15");
    EXPECT_EQ(experiment->panels.size(), 6U);
    std::size_t slow = 0, fast = 0;
    for (const std::vector<Cell>& row : experiment->rows) {
        if (number(row[2]) == 0) {
            EXPECT_EQ(number(row[4]), 0);
        }
        if (number(row[4]) > 0) ++(number(row[0]) == kSlowSpeed ? slow : fast);
    }
    EXPECT_GT(slow, 5 * fast);
    EXPECT_GT(fast, 20U);
}

/// The bur touches the slot on all sides. It must not oscillate, sink or stick.
TEST(SlotTiming, AToolAtRestInItsSlotIsSteadyAndCanLeave) {
    auto layered = LayeredTooth::make(test::box(Vec3(-4, -4, -4), Vec3(4, 4, 0)));
    const auto block = std::make_shared<const LayeredTooth>(std::move(*layered));
    for (const bool probe : {false, true}) {
        const std::vector<SlotTiming> timings = timeInSlot(block, *findBur("57"), 1, 0.05, probe);
        ASSERT_EQ(timings.size(), kSlotMotions.size());
        for (const SlotTiming& timing : timings) {
            SCOPED_TRACE(slotMotionName(timing.motion));
            EXPECT_TRUE(timing.leaves);
            EXPECT_GT(timing.ticks, 1000U);
            EXPECT_GT(timing.force, 0.1);
            EXPECT_GT(timing.p50, 0);
            EXPECT_LE(timing.p50, timing.p999);
        }
        EXPECT_LE(timings[0].noise, 0.005);
        EXPECT_LE(std::abs(timings[0].sunk), 1e-3);
    }
}

}  // namespace
}  // namespace tactooth
