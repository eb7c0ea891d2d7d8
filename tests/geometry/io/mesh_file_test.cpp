// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/io/mesh_file.h"

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
        ASSERT_TRUE(mesh) << mesh.error().message();
        EXPECT_EQ(mesh->triangles.size(), 4U);
    }
}

TEST(LoadMesh, AnotherMeshFormatIsNamed) {
    const test::TemporaryFolder folder;
    write(folder / "a.OFF", "OFF\n0 0 0\n");
    EXPECT_THAT(loadMesh(folder / "a.OFF").error().message(),
                HasSubstr(".off files cannot be read; export the surface as STL, OBJ or PLY"));
}

TEST(LoadMesh, ReadsObjByItsNameAndPlyByItsContent) {
    const test::TemporaryFolder folder;
    write(folder / "a.OBJ", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(loadMesh(folder / "a.OBJ").value().triangles.size(), 1U);
    write(folder / "a.stl",
          "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
          "property float z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n"
          "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    EXPECT_EQ(loadMesh(folder / "a.stl").value().triangles.size(), 1U);
}

TEST(LoadMesh, TextInUtf16IsNamed) {
    using namespace std::string_literals;
    const test::TemporaryFolder folder;
    for (const char* const name : {"a.obj", "a.ply", "a.stl"}) {
        for (const std::string& text : {"\xFF\xFEv\0 \0"s, "\xFE\xFF\0v\0 "s}) {
            write(folder / name, text);
            EXPECT_THAT(loadMesh(folder / name).error().message(),
                        HasSubstr("this is text in UTF-16; save it as UTF-8."));
        }
    }
}

TEST(LoadMesh, TheMacsNotesOnAFileAreNamed) {
    using namespace std::string_literals;
    const test::TemporaryFolder folder;
    write(folder / "._a.stl", "\0\5\x16\7\0\2\0\0Mac OS X        "s);
    EXPECT_THAT(loadMesh(folder / "._a.stl").error().message(), HasSubstr("this is a Mac's notes on a file"));
}

const char* const kFar =
    "solid a\rfacet normal 0 0 0\router loop\rvertex 1000000.001 0 0\rvertex 1000020.001 0 0\r"
    "vertex 1000000.001 20 0\rendloop\rendfacet\rendsolid\r";

TEST(ReadMesh, AFarSurfaceComesWithItsOffsetAndTheFileNameAlone) {
    const test::TemporaryFolder folder;
    write(folder / "a.stl", kFar);
    const auto read = readMesh(folder / "a.stl");
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_EQ(read->offset, Vec3(1000010, 10, 0));
    EXPECT_EQ(read->mesh.vertices[0], Vec3f(-9.999F, -10, 0));
    EXPECT_TRUE(inWords(read->importNotes.at(0)).starts_with("a.stl: the surface lies too far from zero"));
}

TEST(LoadMesh, NeverShiftsInSilence) {
    const test::TemporaryFolder folder;
    write(folder / "a.stl", kFar);
    EXPECT_THAT(loadMesh(folder / "a.stl").error().message(), HasSubstr("lies too far from zero for single precision"));
}

TEST(LoadMesh, HandsRemarksOn) {
    const test::TemporaryFolder folder;
    write(folder / "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nwhat\n");
    std::vector<ImportNote> importNotes;
    EXPECT_TRUE(loadMesh(folder / "a.obj", &importNotes));
    EXPECT_EQ(importNotes.size(), 1u);
    EXPECT_TRUE(loadMesh(folder / "a.obj"));
}

TEST(LoadMesh, AMissingFileIsReportedBeforeItsFormat) {
    EXPECT_THAT(loadMesh("/nowhere/a.obj").error().message(), HasSubstr("there is no such file"));
}

}  // namespace
}  // namespace tactooth
