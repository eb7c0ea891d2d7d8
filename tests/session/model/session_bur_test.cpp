// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/session_bur.h"

#include <gtest/gtest.h>

#include "bench_scene.h"
#include "session/model/spin_envelope_mesh.h"

namespace tactooth {
namespace {

CustomBur customBur(TriangleMesh surface) {
    return {.name = "My bur", .surface = std::move(surface), .material = BurMaterial::Diamond, .flutes = 0};
}

TEST(SessionBur, OfTheCatalogueHasItsNameMaterialAndEdge) {
    const BurSpec spec = *findBur("4");
    const auto bur = makeSessionBur(spec);
    ASSERT_TRUE(bur);
    EXPECT_EQ(bur->name, spec.name);
    EXPECT_EQ(bur->material, spec.material);
    EXPECT_EQ(bur->instrument.edge.flutes, spec.edge().flutes);
    EXPECT_TRUE(bur->file.empty());
}

TEST(SessionBur, IsShownFinerThanItIsTouched) {
    const auto bur = makeSessionBur(*findBur("4"));
    ASSERT_TRUE(bur);
    EXPECT_GT(bur->shown->triangles.size(), bur->instrument.shape->mesh().triangles.size());
}

TEST(SessionBur, OfACaseKeepsItsDescription) {
    const auto bur = makeSessionBur(customBur(test::flatBurMesh()), {});
    ASSERT_TRUE(bur);
    EXPECT_EQ(bur->name, "My bur");
    EXPECT_EQ(bur->material, BurMaterial::Diamond);
    EXPECT_EQ(bur->instrument.edge.flutes, 0);
    EXPECT_NEAR(bur->instrument.cutting.envelope.maxRadius(), test::kBurRadius, 0.01);
}

TEST(SessionBur, AFailureNamesTheFileOrElseTheBur) {
    const auto ofCase = makeSessionBur(customBur({}), {});
    ASSERT_FALSE(ofCase);
    EXPECT_EQ(ofCase.error().message().find("My bur: "), 0U);
    const auto ofFile = makeSessionBur(customBur({}), "bur.stl");
    ASSERT_FALSE(ofFile);
    EXPECT_EQ(ofFile.error().message().find("bur.stl: "), 0U);
}

TEST(SessionBur, AFileThatIsMissingFails) { EXPECT_FALSE(loadSessionBur("/nowhere/bur.stl")); }

/// Closed form: the envelope of a cylinder is the cylinder.
TEST(SpinEnvelopeMesh, OfACylinderIsTheCylinder) {
    const auto envelope = RevolutionEnvelope::make(test::flatBurMesh());
    ASSERT_TRUE(envelope);
    const TriangleMesh mesh = spinEnvelopeMesh(*envelope);
    ASSERT_FALSE(mesh.triangles.empty());
    double widest = 0, lowest = 1, highest = 0;
    for (const Vec3f& vertex : mesh.vertices) {
        widest = std::max<double>(widest, vertex.head<2>().norm());
        lowest = std::min<double>(lowest, vertex.z());
        highest = std::max<double>(highest, vertex.z());
    }
    EXPECT_NEAR(widest, test::kBurRadius, 0.01);
    EXPECT_NEAR(lowest, 0, 0.01);
    EXPECT_NEAR(highest, 4, 0.01);
}

TEST(SessionBur, AHandInstrumentIsFoundAgainByItsTitle) {
    for (const HandInstrumentSpec& spec : handInstruments()) {
        const SessionBur made = makeHandInstrument(spec.kind);
        EXPECT_TRUE(made.isHandInstrument());
        EXPECT_EQ(made.name, spec.title->english);
        EXPECT_GT(made.shown->triangles.size(), made.instrument.shape->mesh().triangles.size());
        SessionWork work;
        work.bur = made.name;
        const std::optional<SessionBur> again = burOf(work, {});
        ASSERT_TRUE(again) << spec.name;
        EXPECT_EQ(again->instrument.hand, spec.kind);
    }
    SessionWork bur;
    bur.bur = burCatalogue().front().name;
    EXPECT_FALSE(burOf(bur, {})->isHandInstrument());
}

}  // namespace
}  // namespace tactooth
