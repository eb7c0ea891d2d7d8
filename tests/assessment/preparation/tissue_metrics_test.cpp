// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "assessment/preparation/prepared_blocks.h"
#include "support/materials.h"
#include "support/shapes.h"

// Volumes of tissues and enamel without dentin below, on blocks with known ones.

namespace tactooth {
namespace {

using namespace test;

/// The block: enamel down to z = 4 and 1 mm from each side, dentin below, pulp from z = 1 to 2, and decay from z = 2.5
/// to 4.5 between x = -1 and 1, y = -1 and 1.
Preparation layered(TriangleMesh prepared, TriangleMesh ideal) {
    const MaterialRegistry& materials = builtinMaterials();
    const auto layer = [&](std::string name, MaterialRole role, TriangleMesh mesh) {
        return LayerMesh{std::move(name), materials.withRole(role), std::move(mesh)};
    };
    std::vector<LayerMesh> layers;
    layers.push_back(layer("enamel", MaterialRole::Enamel, box(Vec3(-5, -5, -5), Vec3(5, 5, 5))));
    layers.push_back(layer("dentin", MaterialRole::Dentin, box(Vec3(-4, -4, -4), Vec3(4, 4, 4))));
    layers.push_back(layer("pulp", MaterialRole::Pulp, box(Vec3(-3, -3, 1), Vec3(3, 3, 2))));
    layers.push_back(layer("decay", MaterialRole::Decay, box(Vec3(-1, -1, 2.5), Vec3(1, 1, 4.5))));
    auto tooth = LayeredTooth::make(box(Vec3(-5, -5, -5), Vec3(5, 5, 5)), std::move(layers));
    EXPECT_TRUE(tooth) << tooth.error().message();
    Preparation preparation = blockPreparation(std::move(prepared), std::move(ideal));
    preparation.tooth = std::make_shared<const LayeredTooth>(std::move(*tooth));
    return preparation;
}

TEST(TissueMetrics, AreTheVolumesOfTheBoxes) {
    // Ideal: 4 x 3 mm, 2.5 mm deep: all decay. Student: 5 x 3 mm, 1.5 mm deep.
    const PreparationMeasures measures(
        layered(blockWithBox(-2, 3, -1.5, 1.5, 3.5), blockWithBox(-2, 2, -1.5, 1.5, 2.5)));
    const double decay = 2 * 2 * 2, taken = 2 * 2 * 1.0;
    EXPECT_NEAR(valueOf(measures, "removed_decay"), taken, 0.02 * taken);
    EXPECT_NEAR(valueOf(measures, "decay_left"), decay - taken, 0.02 * decay);
    EXPECT_NEAR(valueOf(measures, "decay_share"), 0.5, 0.01);
    EXPECT_NEAR(valueOf(measures, "removed_enamel"), 5 * 3 * 1.0 - 2 * 2 * 0.5, 0.2);
    EXPECT_NEAR(valueOf(measures, "removed_dentin"), 5 * 3 * 0.5 - 2 * 2 * 0.5, 0.1);
    EXPECT_NEAR(valueOf(measures, "removed_pulp"), 0, 1e-9);
    EXPECT_NEAR(valueOf(measures, "over_enamel"), 1 * 3 * 1.0, 0.05);
    EXPECT_NEAR(valueOf(measures, "over_dentin"), 1 * 3 * 0.5, 0.03);
    const double all =
        valueOf(measures, "removed_enamel") + valueOf(measures, "removed_dentin") + valueOf(measures, "removed_decay");
    EXPECT_NEAR(all, measures.volumes.common + measures.volumes.over, 1e-6);
}

TEST(TissueMetrics, WhatIsLeftUndoneIsMeasuredByTissue) {
    // Ideal: 4 x 3 mm, 2 mm deep. Student: 3 x 3 mm, 0.5 mm deep; decay lies between x, y = -1 and 1 from z = 4.5 down.
    const PreparationMeasures measures(layered(blockWithBox(-2, 1, -1.5, 1.5, 4.5), blockWithBox(-2, 2, -1.5, 1.5, 3)));
    EXPECT_NEAR(valueOf(measures, "under_enamel"), 3 * 3 * 0.5 - 2 * 2 * 0.5 + 1 * 3 * 1.0, 0.1);
    EXPECT_NEAR(valueOf(measures, "under_dentin"), 4 * 3 * 1.0 - 2 * 2 * 1.0, 0.1);
    EXPECT_NEAR(valueOf(measures, "over_enamel"), 0, 0.01);
}

TEST(TissueMetrics, TheRateOfDecayIsItsVolumeByTheTimeOfDrilling) {
    PreparationMeasures measures(layered(blockWithBox(-2, 3, -1.5, 1.5, 3.5), blockWithBox(-2, 2, -1.5, 1.5, 2.5)));
    EXPECT_EQ(reasonOf(measures, "decay_rate"), "no_session");
    EXPECT_EQ(reasonOf(measures, "mirror_time"), "no_session");
    measures.hasSession = true;
    measures.hand = HandWork();
    measures.hand->drilling = 20;
    EXPECT_NEAR(valueOf(measures, "decay_rate"), valueOf(measures, "removed_decay") / 20, 1e-12);
    EXPECT_NEAR(valueOf(measures, "decay_rate"), 4.0 / 20, 0.005);
    measures.hand = HandWork{};
    EXPECT_EQ(reasonOf(measures, "decay_rate"), "never_drilled");
}

TEST(ProcessMetrics, ThePathOfTheExpertIsComparedWithThatOfTheStudent) {
    PreparationMeasures measures(
        blockPreparation(blockWithBox(-2, 2, -1.5, 1.5, 3), blockWithBox(-2, 2, -1.5, 1.5, 3)));
    EXPECT_EQ(reasonOf(measures, "path_ratio"), "no_session");
    measures.hasSession = true;
    measures.hand = HandWork();
    EXPECT_EQ(reasonOf(measures, "path_ratio"), "no_expert_session");
    measures.hasExpertSession = true;
    EXPECT_EQ(reasonOf(measures, "path_ratio"), "expert_never_touched");
    measures.expertHand = HandWork();
    measures.expertHand->path = 150;
    EXPECT_EQ(reasonOf(measures, "path_ratio"), "no_path");
    measures.hand->path = 600;
    EXPECT_NEAR(valueOf(measures, "path_ratio"), 0.25, 1e-12);
}

TEST(TissueMetrics, DecayBesideThePreparationIsLeft) {
    const PreparationMeasures measures(layered(blockWithBox(2, 4, -1, 1, 4.5), blockWithBox(2, 4, -1, 1, 4.5)));
    EXPECT_NEAR(valueOf(measures, "decay_left"), 8, 0.1);
    EXPECT_NEAR(valueOf(measures, "decay_share"), 0, 1e-9);
}

TEST(TissueMetrics, APulpThatIsCutHasAVolume) {
    const PreparationMeasures measures(layered(blockWithBox(-2, 2, -1, 1, 1.5), blockWithBox(-2, 2, -1, 1, 3)));
    EXPECT_NEAR(valueOf(measures, "removed_pulp"), 4 * 2 * 0.5, 0.05);
}

TEST(TissueMetrics, AreNotKnownOfAToothWithoutLayers) {
    const PreparationMeasures measures(
        blockPreparation(blockWithBox(-2, 2, -1.5, 1.5, 3), blockWithBox(-2, 2, -1.5, 1.5, 3)));
    for (const char* id :
         {"removed_enamel", "removed_dentin", "removed_pulp", "removed_decay", "decay_left", "decay_share",
          "over_enamel", "over_dentin", "under_enamel", "under_dentin", "unsupported_enamel"}) {
        EXPECT_EQ(reasonOf(measures, id), "no_tissue_known") << id;
    }
}

TEST(TissueMetrics, AnUprightWallHasDentinBelowItsEnamel) {
    const PreparationMeasures measures(layered(blockWithBox(-2, 2, -1.5, 1.5, 3), blockWithBox(-2, 2, -1.5, 1.5, 3)));
    EXPECT_NEAR(valueOf(measures, "unsupported_enamel"), 0, 1e-9);
}

TEST(TissueMetrics, EnamelOverACavityThatWidensHasNoDentin) {
    // The wall at x = 2 leaves for 2 + 2 tan(20) = 2.73 at the floor, 2 mm deep: its enamel, 1 mm, hangs over.
    const double out = 2 * std::tan(20 * std::numbers::pi / 180);
    const TriangleMesh undercut =
        blockWithCavityTo(Rectangle::level(-2, 2, -1.5, 1.5, 5), Rectangle::level(-2, 2 + out, -1.5, 1.5, 3));
    const PreparationMeasures measures(layered(undercut, undercut));
    const double slope = 1 / std::cos(20 * std::numbers::pi / 180);
    // Of the wall within the enamel, from the depth at which a wall begins to where a line that begins 0.03 mm inside
    // the wall meets dentin first.
    const double first = kCavityDepth, last = 1 - 0.03 / std::sin(20 * std::numbers::pi / 180);
    EXPECT_NEAR(valueOf(measures, "unsupported_enamel"), (last - first) * slope * 3, 0.06);
    EXPECT_GT(findPreparationMetric("unsupported_enamel")->measure(measures).place->x(), 2);
}

}  // namespace
}  // namespace tactooth
