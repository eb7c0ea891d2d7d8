// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/file/remaining_layers.h"

#include <gtest/gtest.h>

#include <numbers>

#include "geometry/io/stl_reader.h"
#include "geometry/io/stl_writer.h"
#include "geometry/mesh/mesh_report.h"
#include "support/materials.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

constexpr double kVoxel = 0.05;

Pose at(double x, double y, double z) { return {Vec3(x, y, z), Quat::Identity()}; }

/// A block with a core that begins 0.5 mm below its top. A hole of 1 mm is drilled 0.8 mm deep.
CutVolume drilledBlock(bool layered) {
    std::vector<LayerMesh> layers;
    if (layered) {
        layers.push_back({"shell", test::kEnamel, test::box(Vec3(-2, -2, -3), Vec3(2, 2, 0))});
        layers.push_back({"core", test::kDentin, test::box(Vec3(-1, -1, -2), Vec3(1, 1, -0.5))});
    }
    auto tooth = LayeredTooth::make(test::box(Vec3(-2, -2, -3), Vec3(2, 2, 0)), std::move(layers));
    CutVolume volume(std::make_shared<const LayeredTooth>(std::move(*tooth)), kVoxel);
    const auto bur = RevolutionEnvelope::make(test::cylinder(Vec3::Zero(), 0.5, 4, 128));
    (void)volume.carve(*bur, at(0.1, 0.1, 0.2), at(0.1, 0.1, -0.8), 0);
    return volume;
}

/// The report on the mesh as a reader of the file sees it: equal points are one.
MeshReport reportOnFileOf(const TriangleMesh& mesh) { return reportOn(*parseStl(stlBytes(mesh), "layer")); }

TEST(RemainingLayer, EachLayerIsClosedAndLacksWhatWasCutOfIt) {
    const std::vector<RemainingLayer> remains = remainingLayers(drilledBlock(true));
    ASSERT_EQ(remains.size(), 2U);
    EXPECT_EQ(remains[0].name, "shell");
    EXPECT_EQ(remains[1].name, "core");
    const double hole = std::numbers::pi * 0.25;  // mm^2
    for (const auto& [layer, whole, depth] : {std::tuple{0, 48.0, 0.8}, std::tuple{1, 6.0, 0.3}}) {
        const MeshReport report = reportOnFileOf(remains[layer].mesh);
        EXPECT_TRUE(report.watertight()) << remains[layer].name;
        EXPECT_NEAR(whole - report.signedVolume, hole * depth, 0.004 * hole * depth) << remains[layer].name;
    }
}

TEST(RemainingLayer, ALayerThatNoBurReachedIsUntouched) {
    CutVolume volume = drilledBlock(true);
    volume.reset();
    const std::vector<RemainingLayer> remains = remainingLayers(volume);
    EXPECT_EQ(remains[1].mesh.triangles.size(), 12U);
}

TEST(RemainingLayer, AToothWithoutLayersIsOne) {
    const std::vector<RemainingLayer> remains = remainingLayers(drilledBlock(false));
    ASSERT_EQ(remains.size(), 1U);
    EXPECT_EQ(remains[0].name, "enamel");
    EXPECT_TRUE(reportOnFileOf(remains[0].mesh).watertight());
}

}  // namespace
}  // namespace tactooth
