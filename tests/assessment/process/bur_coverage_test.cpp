// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/process/bur_coverage.h"

#include <gtest/gtest.h>

#include <cmath>

#include "assessment/preparation/prepared_blocks.h"
#include "session/simulation/tooth_source.h"
#include "support/materials.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

using namespace test;

const TriangleMesh kIdeal = blockWithBox(-2, 2, -1.5, 1.5, 3);  // 4 x 3 mm, 2 mm deep
const double kRadius = std::sqrt(0.5);                          // of the bur below

/// A box that turns: a cylinder of kRadius, 3 mm long.
CuttingTool cylinder() { return makeCuttingTool(box(Vec3(-0.5, -0.5, 0), Vec3(0.5, 0.5, 3))).value(); }

double beyondAt(const Vec3& tip) {
    const Preparation preparation = blockPreparation(kIdeal, kIdeal);
    const CutSurfaces surfaces(preparation);
    const TargetRegion target(preparation.original, preparation.ideal, surfaces.idealCut.mesh);
    std::vector<Vec3> places = headPlaces(cylinder().envelope);
    for (Vec3& each : places) each += tip;
    return target.beyond(places);
}

TEST(TargetRegion, ABurIsAsFarBeyondItAsItLiesInTheToothThatStays) {
    EXPECT_EQ(beyondAt(Vec3(0, 0, 4)), 0);
    EXPECT_NEAR(beyondAt(Vec3(0, 0, 2.8)), 0.2, 1e-6) << "below the floor";
    EXPECT_NEAR(beyondAt(Vec3(2 - kRadius + 0.25, 0, 4)), 0.25, 1e-3) << "in the wall";
    EXPECT_NEAR(beyondAt(Vec3(2.9, 0, 4)), 1, 1e-6) << "a hole beside the cavity: deeper than far away";
}

TEST(TargetRegion, ABurThatTouchesBesideItIsAsFarAwayAsTheMargin) {
    EXPECT_NEAR(beyondAt(Vec3(4, 0, 5)), 4 - kRadius - 2, 0.001);
    EXPECT_NEAR(beyondAt(Vec3(0, 0, 5)), 0, 1e-6) << "the first touch over the cavity";
}

struct Part {
    double seconds;
    Vec3 tip;
    bool touches = true, turns = true;
};

/// A session of a cylinder whose tip rests in one place after the other.
std::shared_ptr<const SessionTrack> trackOf(const std::vector<Part>& parts) {
    auto tooth = LayeredTooth::make(box(Vec3(-5, -5, -5), Vec3(5, 5, 5)), {}, kDentin);
    const CutModel model(std::make_shared<const LayeredTooth>(std::move(*tooth)), 0.5);
    auto track = std::make_shared<SessionTrack>(model, 0);
    const auto shape = std::make_shared<const ToolShape>(box(Vec3(-0.5, -0.5, 0), Vec3(0.5, 0.5, 3)));
    track->add(TrackBur{0, BeginEvent{{shape, cylinder()}, HapticSettings()}});
    TrackChunk chunk;
    double time = 0;
    for (const Part& part : parts) {
        for (const double end = time + part.seconds; time < end - 1e-9; time += 0.01) {
            TrackTick tick;
            tick.time = time;
            tick.position = {part.tip.x(), part.tip.y(), part.tip.z()};
            tick.contacts = part.touches ? 1 : 0;
            tick.speedRpm = part.turns ? 200'000 : 0;
            tick.placed = true;
            chunk.ticks.push_back(tick);
        }
    }
    track->append(std::move(chunk));
    track->finish(std::nullopt, std::nullopt);
    return track;
}

BurCoverage coverageOf(const std::vector<Part>& parts, double tolerance = 0.3, const Pose& pose = {}) {
    Preparation preparation = blockPreparation(kIdeal, kIdeal);
    preparation.tolerance = tolerance;
    return burCoverage(preparation, CutSurfaces(preparation), trackOf(parts).get(), pose);
}

/// 3 s in the cavity, 1.5 s 0.2 mm too deep, 0.9 s 1 mm too deep, 0.6 s beside it; in the air and at rest nothing
/// counts.
const std::vector<Part> kWork = {{3, Vec3(0, 0, 4)},   {1, Vec3(0, 0, 20), false},      {1.5, Vec3(0, 0, 2.8)},
                                 {0.9, Vec3(0, 0, 2)}, {1, Vec3(0, 0, 2), true, false}, {0.6, Vec3(4, 0, 5)}};

TEST(BurCoverage, IsTheShareOfTheTimeOfDrilling) {
    const BurCoverage coverage = coverageOf(kWork);
    EXPECT_NEAR(coverage.target.value.value_or(-1), 0.5, 0.02);
    EXPECT_NEAR(coverage.band.value.value_or(-1), 0.25, 0.02);
    EXPECT_NEAR(coverage.outside.value.value_or(-1), 0.25, 0.02);
    EXPECT_NEAR(*coverage.target.value + *coverage.band.value + *coverage.outside.value, 1, 1e-12);
}

TEST(BurCoverage, TheBandIsAsWideAsTheTolerance) {
    const BurCoverage narrow = coverageOf(kWork, 0.15);
    EXPECT_NEAR(narrow.band.value.value_or(-1), 0, 1e-12);
    EXPECT_NEAR(narrow.outside.value.value_or(-1), 0.5, 0.02);
    EXPECT_NEAR(coverageOf(kWork, 1.05).outside.value.value_or(-1), 0.1, 0.02) << "only the touch beside it";
}

TEST(BurCoverage, FollowsTheSessionIntoTheFrameOfThePreparation) {
    const std::vector<Part> work = {{1, Vec3(0, 0, 14)}};
    EXPECT_EQ(coverageOf(work, 0.3, Pose{Vec3(0, 0, -10), Quat::Identity()}).target.value, 1);
    EXPECT_EQ(coverageOf(work).target.value, 0);
}

TEST(BurCoverage, WithoutASessionAnIdealOrDrillingThereIsNone) {
    const Preparation preparation = blockPreparation(kIdeal, kIdeal);
    EXPECT_EQ(burCoverage(preparation, CutSurfaces(preparation), nullptr).target.reason->id, "no_session");
    const Preparation whole = blockPreparation(kIdeal, box(Vec3(-5, -5, -5), Vec3(5, 5, 5)));
    const auto track = trackOf(kWork);
    EXPECT_EQ(burCoverage(whole, CutSurfaces(whole), track.get()).band.reason->id, "ideal_removes_nothing");
    const BurCoverage idle = coverageOf({{1, Vec3(0, 0, 4), false}, {1, Vec3(0, 0, 4), true, false}});
    EXPECT_EQ(idle.outside.reason->id, "never_drilled");
    EXPECT_FALSE(idle.outside.value);
}

}  // namespace
}  // namespace tactooth
