// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "patient/layer_model.h"

#include <gtest/gtest.h>

#include <map>

#include "geometry/mesh/mesh_report.h"
#include "instruments/builtin_tooth.h"
#include "support/materials.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

double volumeOf(const TriangleMesh& mesh) { return reportOn(mesh).signedVolume; }

const BuiltinTooth& builtIn(int fdi) {
    static std::map<int, BuiltinTooth> teeth;
    const auto found = teeth.find(fdi);
    if (found != teeth.end()) return found->second;
    return teeth[fdi] = makeTooth({.fdi = fdi, .triangles = 6000, .seed = 0, .lesion = {}});
}

class LayerModelOf : public ::testing::TestWithParam<int> {};

TEST_P(LayerModelOf, IsClosedAndMakesATooth) {
    const auto model = modelLayers(builtIn(GetParam()).outer);
    ASSERT_TRUE(model);
    ASSERT_EQ(model->layers.size(), 3u);
    for (const LayerMesh& layer : model->layers) {
        const MeshReport report = reportOn(layer.mesh);
        EXPECT_TRUE(report.watertight()) << layer.name;
        EXPECT_EQ(report.shells.size(), 1u) << layer.name;
    }
    EXPECT_TRUE(LayeredTooth::make(builtIn(GetParam()).outer, model->layers));
}

/// Compared with teeth that were modelled tissue by tissue: similar, and of the same kind.
TEST_P(LayerModelOf, HasAboutTheVolumesOfAWholeModel) {
    const BuiltinTooth& tooth = builtIn(GetParam());
    const auto model = modelLayers(tooth.outer);
    ASSERT_TRUE(model);
    const double dentin = volumeOf(model->layers[1].mesh) / volumeOf(tooth.dentin);
    EXPECT_GT(dentin, 0.75);
    EXPECT_LT(dentin, 1.3);
    const double pulp = volumeOf(model->layers[2].mesh) / volumeOf(tooth.pulp);
    EXPECT_GT(pulp, 0.25);
    EXPECT_LT(pulp, 3);
}

TEST_P(LayerModelOf, RootIsDentinAndTheBitingEdgeEnamel) {
    const BuiltinTooth& tooth = builtIn(GetParam());
    const auto model = modelLayers(tooth.outer);
    ASSERT_TRUE(model);
    const auto layered = LayeredTooth::make(tooth.outer, model->layers);
    ASSERT_TRUE(layered);
    const TriangleMesh& mesh = layered->outer()->mesh();
    int rootFaces = 0, rootDentin = 0, crownFaces = 0, crownEnamel = 0;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const double z = mesh.corner(t, 0).z();
        const auto material = static_cast<MaterialId>(layered->outer()->tag(t));
        if (z < -2) ++rootFaces, rootDentin += material == test::kDentin;
        if (z > 3) ++crownFaces, crownEnamel += material == test::kEnamel;
    }
    EXPECT_GT(rootDentin, 0.99 * rootFaces);
    EXPECT_GT(crownEnamel, 0.99 * crownFaces);
}

INSTANTIATE_TEST_SUITE_P(Teeth, LayerModelOf, ::testing::Values(11, 36, 24),
                         [](const auto& instance) { return "Fdi" + std::to_string(instance.param); });

TEST(LayerModel, StopsOnRequest) {
    const auto model = modelLayers(builtIn(11).outer, [](double part) { return part < 0.5; });
    ASSERT_FALSE(model);
    EXPECT_EQ(model.error().message(), "stopped");
}

TEST(LayerModel, EachRootHasItsCanal) {
    const auto model = modelLayers(builtIn(36).outer);
    ASSERT_TRUE(model);
    Box3 canals;
    for (const Vec3f& vertex : model->layers[2].mesh.vertices) {
        if (vertex.z() < -7 && vertex.z() > -9) canals.extend(vertex.cast<double>());
    }
    EXPECT_LT(canals.min().x(), -1);  // the distal root
    EXPECT_GT(canals.max().x(), 1);   // the mesial one
}

/// As in a micro-CT: the pulp space is a void, with a narrow way out at the apex.
TEST(LayerModel, AVoidIsThePulpSpaceAndHasNoEnamel) {
    const TriangleMesh shell = test::cylinder(Vec3(0, 0, -12), 5, 20, 48);
    TriangleMesh hollow = test::cylinder(Vec3(0, 0, -8), 1.5, 12, 24);
    for (Triangle& triangle : hollow.triangles) std::swap(triangle[0], triangle[1]);
    TriangleMesh outer = shell;
    append(outer, hollow);
    const auto model = modelLayers(outer);
    ASSERT_TRUE(model);
    EXPECT_EQ(model->layers.size(), 2u);
    EXPECT_EQ(inWords(model->how.back()),
              "The surface encloses a void: it is taken as the pulp space, which is empty.");
    const auto tooth = LayeredTooth::make(outer, model->layers);
    ASSERT_TRUE(tooth);
    EXPECT_EQ(tooth->materialAt(Vec3(1.7, 0, 3)), test::kDentin);
    EXPECT_EQ(tooth->materialAt(Vec3(4.8, 0, 4)), test::kEnamel);
}

TEST(LayerModel, AThinPlateHasNoPulp) {
    const auto model = modelLayers(test::box(Vec3(-4, -0.5, -8), Vec3(4, 0.5, 8)));
    ASSERT_TRUE(model);
    EXPECT_EQ(model->layers.size(), 2u);
    EXPECT_EQ(inWords(model->how.back()), "There is no room for a pulp: the tooth has none.");
}

}  // namespace
}  // namespace tactooth
