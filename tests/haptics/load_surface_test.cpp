// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/load_surface.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/io/stl_writer.h"
#include "support/shapes.h"
#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

using ::testing::HasSubstr;

TEST(LoadSurface, AClosedSurfaceHasAnInside) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeStl(test::box(Vec3(-1, -1, -1), Vec3(1, 1, 1)), folder / "box.stl"));
    const auto surface = loadSurface(folder / "box.stl");
    ASSERT_TRUE(surface) << surface.error().message();
    EXPECT_TRUE((*surface)->closed);
    EXPECT_EQ((*surface)->base->mesh().triangles.size(), 12U);
    EXPECT_TRUE((*surface)->patches.empty());
}

TEST(LoadSurface, AnOpenSurfaceHasNone) {
    const test::TemporaryFolder folder;
    TriangleMesh mesh = test::box(Vec3(-1, -1, -1), Vec3(1, 1, 1));
    mesh.triangles.pop_back();
    ASSERT_TRUE(writeStl(mesh, folder / "open.stl"));
    const auto surface = loadSurface(folder / "open.stl");
    ASSERT_TRUE(surface);
    EXPECT_FALSE((*surface)->closed);
}

TEST(LoadSurface, LoadsAToolInItsOwnFrame) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeStl(test::cylinder(Vec3::Zero(), 0.5, 6, 24), folder / "bur.stl"));
    const auto tool = loadTool(folder / "bur.stl");
    ASSERT_TRUE(tool);
    EXPECT_TRUE((*tool)->centre().isApprox(Vec3(0, 0, 3), 1e-6));
}

TEST(LoadSurface, SaysWhatIsWrongWithAFile) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "text.stl", "no surface at all");
    EXPECT_THAT(loadSurface(folder / "none.stl").error().message(), HasSubstr("there is no such file"));
    EXPECT_THAT(loadTool(folder / "none.stl").error().message(), HasSubstr("there is no such file"));
    EXPECT_THAT(loadSurface(folder / "text.stl").error().message(), HasSubstr("text.stl"));
    EXPECT_THAT(loadTool(folder / "text.stl").error().message(), HasSubstr("text.stl"));
}

}  // namespace
}  // namespace tactooth
