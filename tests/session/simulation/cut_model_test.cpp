// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/simulation/cut_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bench_scene.h"
#include "collision/bvh/closest_point.h"
#include "support/materials.h"

namespace tactooth {
namespace {

using test::at;
using test::blockOnTheBench;

constexpr double kTick = 0.01;  // s: coarse, so that a test drills for a second
/// Volume of a hole of that depth, with the clearance that a cut gives, mm^3.
double holeOf(double depth) {
    constexpr double kClearance = kDefaultClearance * test::kVoxel;
    return std::numbers::pi * std::pow(test::kBurRadius + kClearance, 2) * (depth + kClearance);
}

/// The preset that holds its speed best, so that the pedal sets it.
HapticSettings electric() {
    HapticSettings settings;
    settings.spindle = spindlePresets()[1];
    settings.force = {.stiffness = 1.0, .damping = 0.0, .friction = 0.0};
    return settings;
}

struct Drilled {
    double volume = 0;    // mm^3
    double work = 0;      // N*m, as the ticks booked it in the same time
    double time = 0;      // s
    double speedRpm = 0;  // at the end
    double force = 0;     // N, mean
};

/// Presses a flat bur straight down with a constant force for `ticks` ticks, as a compliant hand does. The bur moves in
/// small steps, so everything is counted from the first step to the last.
Drilled drill(CutModel& piece, const Instrument& bur, double newton, double pedal, int ticks) {
    HapticSimulation simulation(bur.shape, test::kBurRadius, piece.surface(), electric());
    for (int i = 0; i < 400; ++i) simulation.step({at(0.01, 0.02, 0.1), pedal, true}, kTick);
    Drilled result;
    Drilled first;
    double proxyZ = 0;
    for (int i = 0; i < ticks; ++i) {
        const Tick tick = simulation.step({at(0.01, 0.02, proxyZ - newton), pedal, true}, kTick);
        proxyZ = tick.contact.proxy.position.z();
        result.speedRpm = tick.spindle.speedRpm;
        result.force += tick.force.wrench.force.z() / ticks;
        if (!piece.feed(bur.cutting, tick, {})) continue;
        (void)simulation.setSurface(piece.surface());
        result.volume = total(piece.removed());
        result.work = tick.spindle.cutWork;
        result.time = tick.time;
        if (first.volume == 0) first = result;
    }
    result.volume -= first.volume;
    result.work -= first.work;
    result.time -= first.time;
    return result;
}

Drilled drillBlock(MaterialId material, double newton, double pedal = 1, double sharpness = 1) {
    const auto piece = blockOnTheBench(material);
    return drill(*piece, test::flatBur(sharpness), newton, pedal, 70);
}

double rate(const Drilled& drilled) { return drilled.volume / drilled.time; }

TEST(CutModel, ASweepRemovesWhatTheBurPassesThrough) {
    const auto piece = blockOnTheBench();
    const auto revision = piece->surface()->revision;
    const double removed = total(piece->sweep(test::flatBur().cutting, at(0, 0, 0.5), at(0, 0, -1)));
    EXPECT_NEAR(removed, std::numbers::pi * test::kBurRadius * test::kBurRadius, 0.01 * removed);  // no clearance
    EXPECT_EQ(total(piece->removed()), removed);
    EXPECT_EQ(piece->surface()->revision, revision);
    piece->refreshSurface();
    EXPECT_GT(piece->surface()->revision, revision);
    EXPECT_FALSE(piece->surface()->patches.empty());
}

TEST(CutModel, ResetBringsTheWholeToothBack) {
    const auto piece = blockOnTheBench();
    const std::uint64_t whole = piece->hash();
    piece->sweep(test::flatBur().cutting, at(0, 0, 0.5), at(0, 0, -1));
    piece->refreshSurface();
    EXPECT_NE(piece->hash(), whole);
    piece->reset(0);
    EXPECT_EQ(piece->hash(), whole);
    EXPECT_EQ(total(piece->removed()), 0);
    EXPECT_TRUE(piece->surface()->patches.empty());
    EXPECT_GT(total(piece->sweep(test::flatBur().cutting, at(0, 0, 0.5), at(0, 0, -1))), 0.4);
}

TEST(CutModel, WhatIsRemovedIsTheMaterialsRateTimesTheWorkBooked) {
    for (const MaterialId material : {test::kEnamel, test::kDentin, test::kCaries}) {
        const Drilled drilled = drillBlock(material, 0.5);
        const double expected = MaterialTable{}[material].removal * drilled.work;
        EXPECT_NEAR(drilled.volume, expected, 0.05 * expected) << builtinMaterials().nameOf(material);
        EXPECT_NEAR(drilled.force, 0.5, 0.01);
    }
}

TEST(CutModel, TheRateGrowsInProportionToTheForce) {
    const Drilled light = drillBlock(test::kDentin, 0.3);
    const Drilled firm = drillBlock(test::kDentin, 0.9);
    EXPECT_NEAR(rate(firm) / rate(light), 3, 0.15);
}

TEST(CutModel, TheRateGrowsInProportionToTheSpeed) {
    const Drilled slow = drillBlock(test::kDentin, 0.6, 0.3);
    const Drilled fast = drillBlock(test::kDentin, 0.6, 1.0);
    ASSERT_GT(fast.speedRpm, 2 * slow.speedRpm);
    EXPECT_NEAR(rate(fast) / rate(slow), fast.speedRpm / slow.speedRpm, 0.05 * fast.speedRpm / slow.speedRpm);
}

TEST(CutModel, MaterialsGiveWayInTheConfiguredRatio) {
    const MaterialTable table;
    const double enamel = rate(drillBlock(test::kEnamel, 0.5));
    for (const MaterialId material : {test::kDentin, test::kCaries}) {
        const double ratio = table[material].removal / table[test::kEnamel].removal;
        EXPECT_NEAR(rate(drillBlock(material, 0.5)) / enamel, ratio, 0.05 * ratio)
            << builtinMaterials().nameOf(material);
    }
}

TEST(CutModel, HalfTheSharpnessIsHalfTheRate) {
    const double sharp = rate(drillBlock(test::kDentin, 0.6));
    EXPECT_NEAR(rate(drillBlock(test::kDentin, 0.6, 1, 0.5)) / sharp, 0.5, 0.025);
}

/// A block of the same height beside the model, with a narrow gap.
Surroundings neighbour() {
    return {std::make_shared<const SurfacePart>(test::box(Vec3(1.55, -1.5, -3), Vec3(4.5, 1.5, 0)),
                                                std::vector<SurfaceTag>{}, 0)};
}

TEST(CutModel, BodiesAroundItAreTouchedAndBelongToNoOtherSurface) {
    const auto piece = blockOnTheBench();
    EXPECT_EQ(piece->contactSurface(), piece->surface());
    piece->surroundBy(neighbour());
    EXPECT_EQ(piece->contactSurface()->patches.size(), 1u);
    EXPECT_TRUE(piece->surface()->patches.empty());  // neither drawn as this tooth nor exported with it
    HapticSimulation simulation(test::flatBur().shape, test::kBurRadius, piece->contactSurface(), electric());
    (void)simulation.step({at(3, 0, 0.2), 0, false}, kTick);
    const Tick tick = simulation.step({at(3, 0, -0.3), 0, false}, kTick);
    EXPECT_NEAR(tick.contact.depth, 0.3, 0.02);
    EXPECT_GT(tick.force.wrench.force.z(), 0.2);
}

TEST(CutModel, ATickSaysWhetherABodyAroundItHoldsTheTool) {
    const auto piece = blockOnTheBench();
    piece->surroundBy(neighbour());
    const Instrument bur = test::flatBur();
    HapticSimulation simulation(bur.shape, test::kBurRadius, piece->contactSurface(), electric());
    (void)simulation.step({at(3, 0, 0.2), 0, false}, kTick);
    EXPECT_EQ(simulation.step({at(3, 0, -0.3), 0, false}, kTick).contact.around, test::kEnamel);
    (void)simulation.step({at(3, 0, 0.2), 0, false}, kTick);
    (void)simulation.step({at(0, 0, 0.2), 0, false}, kTick);
    const Tick own = simulation.step({at(0, 0, -0.3), 0, false}, kTick);
    EXPECT_GT(own.contact.triangles, 0);
    EXPECT_EQ(own.contact.around, std::nullopt);
    for (int i = 0; i < 400; ++i) simulation.step({at(0, 0, 0.1), 1, true}, kTick);
    Tick tick;
    for (int i = 0; i < 200; ++i) {  // in a cavity of its own, whose patches come before the neighbour
        tick = simulation.step({at(0, 0, -0.5), 1, true}, kTick);
        if (piece->feed(bur.cutting, tick, {})) (void)simulation.setSurface(piece->contactSurface());
    }
    EXPECT_GT(piece->contactSurface()->patches.size(), 1U);
    EXPECT_GT(tick.contact.triangles, 0);
    EXPECT_EQ(tick.contact.around, std::nullopt);
}

TEST(CutModel, BodiesAroundItAreNotCut) {
    const auto piece = blockOnTheBench();
    piece->surroundBy(neighbour());
    const Instrument bur = test::flatBur();
    HapticSimulation simulation(bur.shape, test::kBurRadius, piece->contactSurface(), electric());
    for (int i = 0; i < 400; ++i) simulation.step({at(3, 0, 0.1), 1, true}, kTick);
    Tick tick;
    for (int i = 0; i < 60; ++i) {
        tick = simulation.step({at(3, 0, -0.5), 1, true}, kTick);
        if (piece->feed(bur.cutting, tick, {})) (void)simulation.setSurface(piece->contactSurface());
    }
    EXPECT_EQ(total(piece->removed()), 0);
    EXPECT_NEAR(tick.contact.proxy.position.z(), 0, 0.02);
}

TEST(CutModel, ABodyOfTheSameToothAroundItIsCutAndCounted) {
    TriangleMesh outer = test::box(Vec3(-1.5, -1.5, -3), Vec3(1.5, 1.5, 0));
    const auto first = static_cast<std::uint32_t>(outer.triangles.size());
    append(outer, test::box(Vec3(1.55, -1.5, -3), Vec3(4.5, 1.5, 0)));
    auto tooth = LayeredTooth::make(std::move(outer), {}, test::kDentin, {.firstAdjacent = first});
    CutModel piece(std::make_shared<const LayeredTooth>(std::move(*tooth)), test::kVoxel);
    const Instrument bur = test::flatBur();
    piece.sweep(bur.cutting, at(0, 0, 0.5), at(0, 0, -0.3));
    piece.refreshSurface();
    EXPECT_EQ(piece.loss().beside, 0);
    const double own = total(piece.removed());
    piece.mark(0);
    HapticSimulation simulation(bur.shape, test::kBurRadius, piece.contactSurface(), electric());
    for (int i = 0; i < 400; ++i) simulation.step({at(3, 0, 0.1), 1, true}, kTick);
    Tick tick;
    for (int i = 0; i < 200; ++i) {
        tick = simulation.step({at(3, 0, -0.5), 1, true}, kTick);
        if (piece.feed(bur.cutting, tick, {})) (void)simulation.setSurface(piece.contactSurface());
    }
    EXPECT_LT(tick.contact.proxy.position.z(), -0.1);
    EXPECT_EQ(tick.contact.around, test::kDentin) << "its cut wall is known as well";
    const double beside = total(piece.removed()) - own;
    EXPECT_GT(beside, 0.05);
    EXPECT_NEAR(piece.loss().beside, beside, 0.01 * beside);
    EXPECT_TRUE(piece.undo());
    EXPECT_NEAR(piece.loss().beside, 0, 1e-9);
}

TEST(CutModel, ABurWithoutEdgeLeavesTheToothWhole) {
    const auto piece = blockOnTheBench();
    const Drilled drilled = drill(*piece, test::flatBur(0), 1, 1, 50);
    EXPECT_EQ(drilled.volume, 0);
    EXPECT_EQ(total(piece->removed()), 0);
    EXPECT_NEAR(drilled.force, 1, 0.01);
}

Tick pressing(double cutWork, double depth = 0.5, int contacts = 1) {
    Tick tick;
    tick.contact.proxy = at(0, 0, 0);
    tick.input.device = at(0, 0, -depth);
    tick.input.cutting = true;
    tick.contact.triangles = contacts;
    tick.spindle.cutWork = cutWork;
    return tick;
}

TEST(CutModel, WorkIsSpentOnce) {
    const auto piece = blockOnTheBench();
    const CuttingTool bur = test::flatBur().cutting;
    EXPECT_TRUE(piece->feed(bur, pressing(1), {}));
    const double removed = total(piece->removed());
    EXPECT_NEAR(removed, MaterialTable{}[test::kDentin].removal, 0.03 * removed);
    for (int i = 0; i < 20; ++i) piece->feed(bur, pressing(1), {});
    EXPECT_LE(total(piece->removed()), MaterialTable{}[test::kDentin].removal * (1 + 1e-9));
}

TEST(CutModel, WorkDoneInTheAirOrBeforeIsNotSpentLater) {
    const auto piece = blockOnTheBench();
    const CuttingTool bur = test::flatBur().cutting;
    EXPECT_FALSE(piece->feed(bur, pressing(100, 0.5, 0), {}));
    EXPECT_FALSE(piece->feed(bur, pressing(100), {}));
    EXPECT_FALSE(piece->feed(bur, pressing(1), {}));  // a new simulation begins to count
    EXPECT_EQ(total(piece->removed()), 0);
    EXPECT_TRUE(piece->feed(bur, pressing(2), {}));
}

TEST(CutModel, WorkThatFindsNothingToCutIsNotSavedUp) {
    const auto piece = blockOnTheBench();
    const CuttingTool bur = test::flatBur().cutting;
    piece->feed(bur, pressing(1000, 0.1), {});  // many times the work that a tenth of a millimetre requires
    const double removed = total(piece->removed());
    EXPECT_NEAR(removed, holeOf(0.1), 0.02 * removed);
    Tick deeper = pressing(1000.001, 1);
    deeper.contact.proxy = at(0, 0, -0.1);
    piece->feed(bur, deeper, {});
    EXPECT_LE(total(piece->removed()) - removed, 0.31 * MaterialTable{}[test::kDentin].removal);
}

TEST(CutModel, TheNextCutBeginsAtTheEndOfTheLastOneWhileTheBurMovesThere) {
    const auto piece = blockOnTheBench();
    const CuttingTool bur = test::flatBur().cutting;
    EXPECT_FALSE(piece->reached());
    piece->feed(bur, pressing(1000), {});
    ASSERT_TRUE(piece->reached());
    EXPECT_NEAR(piece->reached()->position.z(), -0.1, 1e-9);
    piece->feed(bur, pressing(2000), {});
    EXPECT_NEAR(piece->reached()->position.z(), -0.2, 1e-9);
    for (int i = 3; i < 8; ++i)
        piece->feed(bur, pressing(1000 * i), {});  // it does not run away from a bur that is held
    EXPECT_NEAR(total(piece->removed()), holeOf(0.2), 0.02 * holeOf(0.2));
    piece->feed(bur, pressing(9000, 0.5, 0), {});
    EXPECT_FALSE(piece->reached());
}

TEST(CutModel, AfterAResetTheFirstCutIsThatOfAFreshPieceBitForBit) {
    const CuttingTool bur = test::flatBur().cutting;
    const auto used = blockOnTheBench();
    used->feed(bur, pressing(1000), {});  // a long feed: the next search would begin as far ahead
    used->reset(0);
    const auto fresh = blockOnTheBench();
    for (CutModel* piece : {used.get(), fresh.get()}) {
        piece->feed(bur, pressing(2000, 0.5, 0), {});  // no work is left over
        ASSERT_TRUE(piece->feed(bur, pressing(2000.3), {}));
    }
    EXPECT_EQ(used->hash(), fresh->hash());
    EXPECT_EQ(used->reached()->position, fresh->reached()->position);
}

/// The bur was pushed into the block; no clearance is cut around it.
Tick pushedIn(double cutWork) {
    Tick tick = pressing(cutWork, 0.7);
    tick.contact.proxy = at(0, 0, -0.2);
    return tick;
}

TEST(CutModel, AStepIsCutAsSoonAsThereIsTheWorkThatItRequires) {
    const CuttingTool bur = test::flatBur().cutting;
    const auto piece = blockOnTheBench();
    CutVolume other(blockOnTheBench()->volume().tooth(), test::kVoxel);
    const double required = workFor(other.removable(bur.envelope, at(0, 0, -0.2), at(0, 0, -0.2)).volumes, {}, 1);
    piece->feed(bur, pressing(10, 0.5, 0), {});  // no work is left over
    const double part = required / 200;
    int parts = 1;
    while (parts < 400 && !piece->feed(bur, pushedIn(10 + parts * part), {})) ++parts;
    EXPECT_NEAR(parts, 200, 2);
}

/// So its readers must not take "the surface is the same" for "nothing was removed".
TEST(CutModel, ACutThatMovesNoPartOfTheSurfaceStillRemovesVolume) {
    const CuttingTool bur = test::flatBur().cutting;
    const auto piece = blockOnTheBench();
    piece->feed(bur, pressing(1000, 0.1), {});
    int unseen = 0;
    for (int i = 0; i < 400; ++i) {
        const MaterialVolumes before = piece->removed();
        Tick tick = pressing(1000 + 1e-6 * i, 0.1 + 1e-6 * i);
        tick.contact.proxy = at(0, 0, -0.1);
        if (!piece->feed(bur, tick, {}) && piece->removed() != before) ++unseen;
    }
    EXPECT_GT(unseen, 0);
}

TEST(CutModel, TheSurfaceKeepsUpWithEachCut) {
    const auto piece = blockOnTheBench();
    const auto before = piece->surface();
    ASSERT_TRUE(piece->feed(test::flatBur().cutting, pressing(5), {}));
    EXPECT_NE(piece->surface(), before);
    EXPECT_GT(piece->surface()->revision, before->revision);
    EXPECT_TRUE(before->patches.empty());  // a snapshot never changes
}

Tick tickAt(double time, int contacts) {
    Tick tick;
    tick.time = time;
    tick.contact.triangles = contacts;
    return tick;
}

constexpr double kRidge = 3 * 1.1 * 0.4;  // mm^3

TEST(CutModel, WhatHasComeLooseFallsWhenTheBurIsLifted) {
    const auto piece = blockOnTheBench();
    EXPECT_FALSE(piece->removeDetachedPieces(tickAt(0, 0)));
    test::cutARidgeOff(*piece);
    const double ground = total(piece->removed());
    EXPECT_FALSE(piece->removeDetachedPieces(tickAt(1.00, 1)));
    EXPECT_FALSE(piece->removeDetachedPieces(tickAt(1.09, 0)));  // it may be on its way over a gap
    EXPECT_EQ(piece->loss().pieces, 0U);
    EXPECT_TRUE(piece->removeDetachedPieces(tickAt(1.11, 0)));
    EXPECT_EQ(piece->loss().pieces, 1U);
    EXPECT_NEAR(total(piece->loss().detached), kRidge, 0.025 * kRidge);
    EXPECT_NEAR(total(piece->loss().ground()), ground, 1e-9);
    EXPECT_EQ(total(piece->removed()), ground + total(piece->loss().detached));
    EXPECT_FALSE(contains(*piece->surface(), Vec3(0, 1, -0.2)));
    EXPECT_FALSE(piece->removeDetachedPieces(tickAt(1.5, 0)));  // there is nothing more
}

TEST(CutModel, TheTimeOfTheLastContactIsThatOfTheSimulationWhichRuns) {
    const auto piece = blockOnTheBench();
    EXPECT_FALSE(piece->removeDetachedPieces(tickAt(100, 1)));
    test::cutARidgeOff(*piece);
    EXPECT_FALSE(piece->removeDetachedPieces(tickAt(0.01, 0)));  // another simulation begins at zero
    EXPECT_TRUE(piece->removeDetachedPieces(tickAt(0.2, 0)));
}

TEST(CutModel, ASearchThatFindsNoDetachedPieceStillShowsTheCut) {
    const auto piece = blockOnTheBench();
    piece->sweep(test::flatBur().cutting, at(0, 0, 0.5), at(0, 0, -1));  // not shown yet
    EXPECT_TRUE(piece->removeDetachedPieces());
    EXPECT_FALSE(piece->surface()->patches.empty());
    EXPECT_EQ(total(piece->loss().detached), 0);
    EXPECT_FALSE(piece->removeDetachedPieces());
}

TEST(CutModel, UndoPutsTheFallenPieceBack) {
    const auto piece = blockOnTheBench();
    piece->mark(0);
    test::cutARidgeOff(*piece);
    ASSERT_TRUE(piece->removeDetachedPieces());
    ASSERT_TRUE(piece->undo());
    EXPECT_EQ(piece->loss().pieces, 0U);
    EXPECT_EQ(total(piece->loss().detached), 0);
    EXPECT_TRUE(contains(*piece->surface(), Vec3(0, 1, -0.2)));
    EXPECT_FALSE(piece->removeDetachedPieces());
}

}  // namespace
}  // namespace tactooth
