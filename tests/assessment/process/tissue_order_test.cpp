// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/process/tissue_order.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "assessment/cause/two_holes.h"
#include "support/materials.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

using namespace test;

LayerMesh layer(const std::string& name, MaterialRole role, TriangleMesh mesh) {
    return {name, builtinMaterials().withRole(role), std::move(mesh)};
}

/// Enamel down to z = 4, dentin below, pulp from z = 1 to 2, and decay from z = 2.5 to 4.5 between x, y = -1 and 1.
LayeredTooth block(bool hasDecay = true, bool hasPulp = true) {
    std::vector<LayerMesh> layers;
    layers.push_back(layer("enamel", MaterialRole::Enamel, box(Vec3(-5, -5, -5), Vec3(5, 5, 5))));
    layers.push_back(layer("dentin", MaterialRole::Dentin, box(Vec3(-4, -4, -4), Vec3(4, 4, 4))));
    if (hasPulp) layers.push_back(layer("pulp", MaterialRole::Pulp, box(Vec3(-3, -3, 1), Vec3(3, 3, 2))));
    if (hasDecay) layers.push_back(layer("decay", MaterialRole::Decay, box(Vec3(-1, -1, 2.5), Vec3(1, 1, 4.5))));
    return std::move(*LayeredTooth::make(box(Vec3(-5, -5, -5), Vec3(5, 5, 5)), std::move(layers)));
}

TEST(DecayPieces, FillTheDecayAndKnowPulpAndEnamel) {
    const std::vector<DecayPiece> pieces = decayPieces(block());
    EXPECT_EQ(pieces.size(), 20U * 20 * 20) << "8 mm^3 in cubes of 0.1 mm";
    for (const DecayPiece& each : pieces) {
        ASSERT_NEAR(each.toPulp, each.place.z() - 2, 1e-6);
        ASSERT_NEAR(each.belowJunction, 4 - each.place.z(), 1e-6);
    }
    EXPECT_TRUE(decayPieces(block(false)).empty());
    EXPECT_TRUE(decayPieces(block(true, false)).empty());
}

DecayOrder orderBy(const std::function<std::optional<double>(const Vec3&)>& timeOf) {
    const std::vector<DecayPiece> pieces = decayPieces(block());
    std::vector<std::optional<double>> times;
    for (const DecayPiece& each : pieces) times.push_back(timeOf(each.place));
    return decayOrder(pieces, times);
}

TEST(DecayOrder, FromTheEnamelToThePulpIsRight) {
    const DecayOrder order = orderBy([](const Vec3& place) { return 5 - place.z(); });
    EXPECT_EQ(order.peripheryFirst.value, 1);
    EXPECT_EQ(order.deepEarly.value, 0);
}

TEST(DecayOrder, FromThePulpToTheEnamelIsWrong) {
    const DecayOrder order = orderBy([](const Vec3& place) { return place.z(); });
    EXPECT_EQ(order.peripheryFirst.value, 0);
    EXPECT_EQ(order.deepEarly.value, 1);
}

/// Columns beside one another, each of them whole at one moment. When 18 of 20 have gone, so have 90 % of the
/// periphery; before that moment 17 had.
TEST(DecayOrder, SideBySideIsNoOrder) {
    const DecayOrder order = orderBy([](const Vec3& place) { return std::round(10 * place.x() + 9.5); });
    EXPECT_NEAR(order.peripheryFirst.value.value_or(-1), 0.5, 1e-12);
    EXPECT_NEAR(order.deepEarly.value.value_or(-1), 17.0 / 20, 1e-12);
}

/// Ten pieces along the enamel at 1 to 10 s; of ten deep ones `early` at 5.5 s, the others at 20 s. Between them a
/// piece that is neither.
DecayOrder orderOfTen(int early) {
    std::vector<DecayPiece> pieces;
    std::vector<std::optional<double>> times;
    for (int i = 0; i < 10; ++i) {
        pieces.push_back({Vec3::Zero(), 2, 0.2});
        times.emplace_back(1.0 + i);
        pieces.push_back({Vec3::Zero(), 0.5, 1.5});
        times.emplace_back(i < early ? 5.5 : 20);
        pieces.push_back({Vec3::Zero(), 1.5, 0.8});
        times.emplace_back(0);
    }
    return decayOrder(pieces, times);
}

TEST(DecayOrder, CountsThePairsOfBothGroups) {
    for (const int early : {0, 3, 10}) {
        const DecayOrder order = orderOfTen(early);
        EXPECT_NEAR(order.peripheryFirst.value.value_or(-1), (10 * (10 - early) + 5 * early) / 100.0, 1e-12) << early;
        EXPECT_NEAR(order.deepEarly.value.value_or(-1), early / 10.0, 1e-12) << early;
    }
}

TEST(DecayOrder, WhatWasNotRemovedHasNoOrder) {
    const DecayOrder shallow =
        orderBy([](const Vec3& place) { return place.z() > 3.5 ? std::optional(1.0) : std::nullopt; });
    EXPECT_FALSE(shallow.peripheryFirst.value);
    EXPECT_EQ(shallow.peripheryFirst.reason->id, "no_deep_decay_removed");
    const DecayOrder deep =
        orderBy([](const Vec3& place) { return place.z() < 3 ? std::optional(1.0) : std::nullopt; });
    EXPECT_EQ(deep.deepEarly.reason->id, "no_periphery_removed");
    EXPECT_EQ(decayOrder({}, {}).deepEarly.reason->id, "no_deep_decay_removed");
}

/// The block of TwoHoles with decay where the holes are made, first at x = -1 and then at x = 1, and with a pulp below
/// one of them. The decay there is half of the other, so it is the deep third.
LayeredTooth twoDecays(double pulpX) {
    std::vector<LayerMesh> layers;
    layers.push_back(layer("enamel", MaterialRole::Enamel, box(Vec3(-3, -2, -3), Vec3(3, 2, 0))));
    layers.push_back(layer("dentin", MaterialRole::Dentin, box(Vec3(-2.9, -1.9, -2.9), Vec3(2.9, 1.9, -0.05))));
    layers.push_back(layer("pulp", MaterialRole::Pulp, box(Vec3(pulpX - 0.4, -0.4, -1.5), Vec3(pulpX + 0.4, 0.4, -1))));
    for (const double x : {-1.0, 1.0}) {
        const double depth = x == pulpX ? 0.25 : 0.45;
        layers.push_back(layer(x < 0 ? "first" : "second", MaterialRole::Decay,
                               box(Vec3(x - 0.2, -0.2, -depth), Vec3(x + 0.2, 0.2, -0.05))));
    }
    return std::move(*LayeredTooth::make(box(Vec3(-3, -2, -3), Vec3(3, 2, 0)), std::move(layers)));
}

TEST(TissueOrder, IsThatOfTheRecordedSession) {
    const TwoHoles* session = TwoHoles::recorded();
    ASSERT_NE(session, nullptr);
    const LayeredTooth right = twoDecays(1), wrong = twoDecays(-1);
    const TissueOrder last = tissueOrder(&right, session->track()), first = tissueOrder(&wrong, session->track());
    EXPECT_EQ(last.decay.peripheryFirst.value, 1);
    EXPECT_EQ(last.decay.deepEarly.value, 0);
    EXPECT_EQ(first.decay.peripheryFirst.value, 0);
    EXPECT_EQ(first.decay.deepEarly.value, 1);
    // The tip begins 0.3 mm over the block, which is of dentin, and comes down with 1.6 mm/s.
    EXPECT_NEAR(last.dentinTime.value.value_or(-1), TwoHoles::kFirstHole + 0.3 / 1.6, 0.05);
}

TEST(TissueOrder, SaysWhyItIsNotKnown) {
    const TwoHoles* session = TwoHoles::recorded();
    ASSERT_NE(session, nullptr);
    const LayeredTooth whole = block(), sound = block(false), withoutPulp = block(true, false);
    EXPECT_EQ(tissueOrder(&whole, nullptr).dentinTime.reason->id, "no_session");
    EXPECT_EQ(tissueOrder(nullptr, session->track()).decay.deepEarly.reason->id, "no_tissue_known");
    EXPECT_EQ(tissueOrder(&sound, session->track()).decay.peripheryFirst.reason->id, "no_decay_known");
    EXPECT_EQ(tissueOrder(&withoutPulp, session->track()).decay.peripheryFirst.reason->id, "no_pulp_known");
}

}  // namespace
}  // namespace tactooth
