// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/model/layered_tooth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/expect_assert.h"
#include "support/materials.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

const Vec3 kLow(-2, -2, -2);
const Vec3 kHigh(2, 2, 2);

LayerMesh boxLayer(const std::string& name, MaterialId material, double halfSide) {
    return {name, material, test::box(Vec3::Constant(-halfSide), Vec3::Constant(halfSide))};
}

std::string failure(TriangleMesh outer, std::vector<LayerMesh> layers) {
    const auto tooth = LayeredTooth::make(std::move(outer), std::move(layers));
    return tooth ? "" : tooth.error().message();
}

TEST(LayeredTooth, WithoutLayersItIsOneMaterial) {
    const auto tooth = LayeredTooth::make(test::box(kLow, kHigh), {}, test::kDentin);
    ASSERT_TRUE(tooth);
    EXPECT_EQ(tooth->materialAt(Vec3::Zero()), test::kDentin);
    EXPECT_EQ(tooth->outer()->tag(0), static_cast<SurfaceTag>(test::kDentin));
}

TEST(LayeredTooth, TheInnerOfNestedLayersWinsInAnyOrder) {
    const auto tooth = LayeredTooth::make(test::box(kLow, kHigh),
                                          {boxLayer("pulp", test::kPulp, 0.5), boxLayer("enamel", test::kEnamel, 2),
                                           boxLayer("dentin", test::kDentin, 1.5)});
    ASSERT_TRUE(tooth);
    EXPECT_EQ(tooth->materialAt(Vec3(0.1, 0.2, 0.3)), test::kPulp);
    EXPECT_EQ(tooth->materialAt(Vec3(1.1, 0.2, 0.3)), test::kDentin);
    EXPECT_EQ(tooth->materialAt(Vec3(1.8, 0.2, 0.3)), test::kEnamel);
}

TEST(LayeredTooth, ACariousLesionEatsIntoEverything) {
    LayerMesh lesion{"lesion", test::kCaries, test::box(Vec3(1, -0.3, -0.3), Vec3(2, 0.3, 0.3))};
    const auto tooth = LayeredTooth::make(
        test::box(kLow, kHigh), {lesion, boxLayer("enamel", test::kEnamel, 2), boxLayer("dentin", test::kDentin, 1.5)});
    ASSERT_TRUE(tooth);
    EXPECT_EQ(tooth->materialAt(Vec3(1.9, 0, 0)), test::kCaries);
    EXPECT_EQ(tooth->materialAt(Vec3(1.2, 0, 0)), test::kCaries);
    EXPECT_EQ(tooth->materialAt(Vec3(1.2, 1, 0)), test::kDentin);
}

TEST(LayeredTooth, AGapBelongsToTheNearestLayer) {
    const auto tooth =
        LayeredTooth::make(test::box(kLow, kHigh), {{"enamel", test::kEnamel, test::box(Vec3(-2, -2, 0.1), kHigh)},
                                                    {"dentin", test::kDentin, test::box(kLow, Vec3(2, 2, -0.1))}});
    ASSERT_TRUE(tooth);
    EXPECT_EQ(tooth->materialAt(Vec3(0, 0, 0.05)), test::kEnamel);
    EXPECT_EQ(tooth->materialAt(Vec3(0, 0, -0.05)), test::kDentin);
}

TEST(LayeredTooth, EachTriangleCarriesTheMaterialBehindIt) {
    const auto tooth =
        LayeredTooth::make(test::box(kLow, kHigh), {{"enamel", test::kEnamel, test::box(Vec3(-2, -2, 0.5), kHigh)},
                                                    {"dentin", test::kDentin, test::box(kLow, Vec3(2, 2, 0.5))}});
    ASSERT_TRUE(tooth);
    const TriangleMesh& mesh = tooth->outer()->mesh();
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const Vec3 area = mesh.areaVector(t);
        if (area.z() == 0) continue;
        const MaterialId expected = area.z() > 0 ? test::kEnamel : test::kDentin;
        EXPECT_EQ(tooth->outer()->tag(t), static_cast<SurfaceTag>(expected));
    }
}

TEST(LayeredTooth, OpenOrInvertedSurfacesAreNamedInTheMessage) {
    LayerMesh open = boxLayer("dentin", test::kDentin, 1);
    open.mesh.triangles.pop_back();
    EXPECT_NE(failure(test::box(kLow, kHigh), {open}).find("layer 'dentin' is open (3 edges"), std::string::npos);

    LayerMesh inverted = boxLayer("pulp", test::kPulp, 1);
    for (Triangle& triangle : inverted.mesh.triangles) std::swap(triangle[1], triangle[2]);
    EXPECT_NE(failure(test::box(kLow, kHigh), {inverted}).find("layer 'pulp' is inside out"), std::string::npos);

    TriangleMesh openTooth = test::box(kLow, kHigh);
    openTooth.triangles.pop_back();
    EXPECT_NE(failure(openTooth, {}).find("the tooth is open"), std::string::npos);
    EXPECT_NE(failure(TriangleMesh{}, {}).find("holds no triangle"), std::string::npos);
}

TEST(LayeredTooth, RepeatedNamesAndLayersElsewhereAreRefused) {
    const LayerMesh layer = boxLayer("dentin", test::kDentin, 1);
    EXPECT_NE(failure(test::box(kLow, kHigh), {layer, layer}).find("'dentin' is given twice"), std::string::npos);
    LayerMesh away = boxLayer("enamel", test::kEnamel, 1);
    for (Vec3f& vertex : away.mesh.vertices) vertex.x() += 50;
    EXPECT_NE(failure(test::box(kLow, kHigh), {away}).find("lies outside the tooth"), std::string::npos);
}

TEST(LayeredTooth, ALayerBesideTheToothIsRefusedThoughItsBoxMeetsTheTooths) {
    // The box of a ball has room for a small ball in each corner.
    LayerMesh corner{"pulp", test::kPulp, test::sphere(Vec3(1.7, 1.7, 1.7), 0.2, 12, 8)};
    EXPECT_NE(failure(test::sphere(Vec3::Zero(), 2, 48, 32), {corner}).find("'pulp' lies outside the tooth"),
              std::string::npos);
    LayerMesh around{"enamel", test::kEnamel, test::sphere(Vec3::Zero(), 3, 48, 32)};
    EXPECT_TRUE(LayeredTooth::make(test::sphere(Vec3::Zero(), 2, 48, 32), {around}));
}

TEST(LayeredToothAsserts, MesialIsOneWayOrTheOther) {
    const TriangleMesh outer = test::box(Vec3(-1, -1, -1), Vec3(1, 1, 1));
    EXPECT_ASSERT(static_cast<void>(LayeredTooth::make(outer, {}, test::kEnamel, {.mesialX = 0.5})));
    const LayeredTooth tooth = *LayeredTooth::make(outer);
    EXPECT_ASSERT(static_cast<void>(tooth.materialAt(Vec3(0, 0, std::nan("")))));
    tooth.validate();
}

}  // namespace
}  // namespace tactooth
