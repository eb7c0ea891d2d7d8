// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "patient/merged_layers.h"

#include <gtest/gtest.h>

#include "geometry/mesh/mesh_report.h"
#include "support/materials.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

std::vector<LayerMesh> stacked(double mismatch, const Vec3& upperLow = Vec3(0, 0, 4)) {
    std::vector<LayerMesh> layers;
    layers.push_back({"dentin", test::kDentin, test::box(Vec3(0, 0, 0), Vec3(4, 4, 4))});
    layers.push_back({"enamel", test::kEnamel, test::box(upperLow, Vec3(4, 4, 6))});
    for (Vec3f& vertex : layers[1].mesh.vertices) {
        if (vertex.z() < 5) vertex.x() += static_cast<float>(mismatch);
    }
    return layers;
}

TEST(MergedLayers, FacesInCommonFallAwayAndTheRestStaysAsItWas) {
    const auto joined = mergeLayers(stacked(0));
    ASSERT_TRUE(joined);
    const MeshReport report = reportOn(joined->outer);
    EXPECT_TRUE(report.watertight());
    EXPECT_EQ(report.triangles, 20u);
    EXPECT_NEAR(report.signedVolume, 96, 1e-6);
    EXPECT_NE(inWords(joined->how).find("within 0.001 mm"), std::string::npos);
}

TEST(MergedLayers, AMismatchIsWeldedAndSaid) {
    const auto joined = mergeLayers(stacked(0.015));
    ASSERT_TRUE(joined);
    EXPECT_TRUE(reportOn(joined->outer).watertight());
    EXPECT_NEAR(reportOn(joined->outer).signedVolume, 96, 0.1);
    EXPECT_NE(inWords(joined->how).find("within 0.020 mm"), std::string::npos) << inWords(joined->how);
}

TEST(MergedLayers, LayersThatOverlapAreJoinedByDistance) {
    const auto joined = mergeLayers(stacked(0, Vec3(0, 0, 3)));
    ASSERT_TRUE(joined);
    EXPECT_TRUE(reportOn(joined->outer).watertight());
    EXPECT_NEAR(reportOn(joined->outer).signedVolume, 96, 5);
    EXPECT_NE(inWords(joined->how).find("made anew"), std::string::npos);
}

TEST(MergedLayers, ASingleLayerIsTheTooth) {
    std::vector<LayerMesh> layers = stacked(0);
    layers.pop_back();
    EXPECT_EQ(mergeLayers(layers).value().outer.triangles, layers.front().mesh.triangles);
}

}  // namespace
}  // namespace tactooth
