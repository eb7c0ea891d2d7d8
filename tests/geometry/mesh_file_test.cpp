// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "geometry/stl_bytes.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

using ::testing::HasSubstr;

void write(const std::filesystem::path& path, std::string_view content) {
    std::ofstream(path, std::ios::binary) << content;
}

TEST(LoadMesh, TheContentDecidesNotTheName) {
    const test::TemporaryFolder folder;
    for (const char* name : {"a.stl", "a.STL", "a.obj", "a"}) {
        write(folder / name, test::binaryStl("", 4, test::kTetrahedron));
        const Expected<TriangleMesh> mesh = loadMesh(folder / name);
        ASSERT_TRUE(mesh) << mesh.error().message;
        EXPECT_EQ(mesh->triangles.size(), 4U);
    }
}

TEST(LoadMesh, AnotherMeshFormatIsNamed) {
    const test::TemporaryFolder folder;
    write(folder / "a.OFF", "OFF\n0 0 0\n");
    EXPECT_THAT(loadMesh(folder / "a.OFF").error().message,
                HasSubstr(".off files cannot be read; export the surface as STL, OBJ or PLY"));
}

TEST(LoadMesh, ReadsObjByItsNameAndPlyByItsContent) {
    const test::TemporaryFolder folder;
    write(folder / "a.OBJ", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(loadMesh(folder / "a.OBJ")->triangles.size(), 1U);
    write(folder / "a.stl",
          "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
          "property float z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n"
          "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    EXPECT_EQ(loadMesh(folder / "a.stl")->triangles.size(), 1U);
}

TEST(LoadMesh, AMissingFileIsToldBeforeItsFormat) {
    EXPECT_THAT(loadMesh("/nowhere/a.obj").error().message, HasSubstr("there is no such file"));
}

}  // namespace
}  // namespace tactooth
