// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/io/obj_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "geometry/mesh/mesh_report.h"

namespace tactooth {
namespace {

using ::testing::HasSubstr;

Expected<ReadMesh> read(const std::string& text) { return parseObj(std::as_bytes(std::span(text)), "a.obj"); }

Expected<TriangleMesh> parse(const std::string& text) {
    auto mesh = read(text);
    if (!mesh) return Unexpected{mesh.error()};
    EXPECT_TRUE(mesh->importNotes.empty()) << inWords(mesh->importNotes.front());
    return std::move(mesh->mesh);
}

const std::string kCorners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

TEST(ObjReader, ReadsATetrahedron) {
    const auto mesh = parse("# made by hand\no t\n" + kCorners + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    ASSERT_TRUE(mesh) << mesh.error().message();
    EXPECT_TRUE(reportOn(*mesh).watertight());
    EXPECT_NEAR(reportOn(*mesh).signedVolume, 1.0 / 6, 1e-6);
}

TEST(ObjReader, TakesTextureAndNormalNumbersAndCountsFromTheEnd) {
    const auto mesh =
        parse(kCorners + "vt 0 0\nvn 0 0 1\nf 1/1/1 3/1/1 2/1/1\r\nf 1//1 2//1 4//1\nf -3/1 -2/1 -1/1\nf 3 1 4\n");
    ASSERT_TRUE(mesh) << mesh.error().message();
    EXPECT_TRUE(reportOn(*mesh).watertight());
}

TEST(ObjReader, SplitsPolygonsAndWeldsEqualPositions) {
    const auto mesh = parse("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 0\nf 1 2 3 4\nf 5 2 3\n");
    ASSERT_TRUE(mesh) << mesh.error().message();
    EXPECT_EQ(mesh->triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}}));
    EXPECT_EQ(mesh->vertices.size(), 4u);
}

TEST(ObjReader, NamesTheLineThatIsWrong) {
    EXPECT_THAT(parse(kCorners + "f 1 2 5\n").error().message(), HasSubstr("a.obj, line 5"));
    EXPECT_THAT(parse(kCorners + "f 1 2\n").error().message(), HasSubstr("three corners"));
    EXPECT_THAT(parse("v 0 zero 0\n").error().message(),
                HasSubstr("line 1: expected a finite coordinate, but found 'zero'"));
    EXPECT_THAT(parse("v 0 inf 0\n").error().message(), HasSubstr("finite"));
    EXPECT_THAT(parse(kCorners + "f 0 1 2\n").error().message(), HasSubstr("'0'"));
}

TEST(ObjReader, RefusesAFileWithoutFaces) {
    EXPECT_THAT(parse(kCorners).error().message(), HasSubstr("holds no faces"));
    EXPECT_FALSE(parse(""));
}

const std::string kTetrahedron = kCorners + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
    return text;
}

/// The same tetrahedron, written in other forms.
class AnyWriting : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(
    ObjReader, AnyWriting,
    ::testing::Values("\xEF\xBB\xBF" + kTetrahedron, "\xEF\xBB\xBF# first\n" + kTetrahedron,
                      "\xEF\xBB\xBF" + replaced(kTetrahedron, "\n", "\r\n"), replaced(kTetrahedron, "\n", "\r"),
                      "\xEF\xBB\xBF" + replaced(kTetrahedron, "\n", "\r"), replaced(kTetrahedron, "f 1 3", "f 1 \\\n3"),
                      replaced(kTetrahedron, "f ", "f \\\r\n "), replaced(kTetrahedron, "v 0 ", "v 0 \\\r \\\r "),
                      replaced(kTetrahedron, "f ", "f \\  \n\t"), kTetrahedron + "f 1 3 \\\n2 \\",
                      replaced(kTetrahedron, "f 1", "g C:\\teeth\\\nf 1"), replaced(kTetrahedron, "v", "# a\\\nv"),
                      replaced(kTetrahedron, "v", "  v"), replaced(kTetrahedron, " ", "\t ")));

TEST_P(AnyWriting, IsTheSameSurface) {
    const auto mesh = parse(GetParam());
    ASSERT_TRUE(mesh) << mesh.error().message();
    EXPECT_EQ(mesh->vertices.size(), 4u);
    EXPECT_EQ(mesh->triangles.front(), (Triangle{0, 2, 1}));
    EXPECT_NEAR(reportOn(*mesh).area, 1.5 + std::sqrt(3) / 2, GetParam().ends_with('\\') ? 0.6 : 1e-6);
}

TEST(ObjReader, CountsLinesThatWereContinued) {
    EXPECT_THAT(parse(kCorners + "f 1 \\\n2 \\\n3\nf 1 2 9\n").error().message(), HasSubstr("line 8: "));
    EXPECT_THAT(parse(kCorners + "f 1 \\\n2 \\\n9\n").error().message(), HasSubstr("line 5: "));
    EXPECT_THAT(parse(replaced(kCorners, "\n", "\r") + "f 1 2 9\r").error().message(), HasSubstr("line 5: "));
}

TEST(ObjReader, NamesLinesThatItDoesNotUnderstand) {
    const auto one = read(kTetrahedron + "w 1 2 3\n");
    ASSERT_TRUE(one);
    EXPECT_EQ(inWords(one->importNotes.at(0)), "a.obj: line 9 was not understood and passed over; it begins with 'w'.");
    const auto three = read("vv 1 2\n" + kTetrahedron + "surf 0 1\nV 1 1 1\n");
    ASSERT_TRUE(three);
    EXPECT_EQ(inWords(three->importNotes.at(0)),
              "a.obj: 3 lines were not understood and passed over; the first is line 1, which begins with 'vv'.");
}

TEST(ObjReader, NormalsTextureGroupsAndMaterialsAreNoLinesToName) {
    EXPECT_TRUE(parse("mtllib a.mtl\no a\ng b\ns off\nusemtl c\nvn 0 0 1\nvt 0 0\nvp 0\n\n#\n" + kTetrahedron +
                      "l 1 2\np 1\nlod 1\n"));
}

TEST(ObjReader, SplitsFacesWithinTheirOutline) {
    const std::string arrow = "v 0 0 0\nv 2 -2 0\nv 1 0 0\nv 2 2 0\n";
    for (const char* const face : {"f 1 2 3 4", "f 2 3 4 1", "f 3 4 1 2", "f 4 3 2 1", "f -4 -3 -2 -1"}) {
        const auto mesh = parse(arrow + face + "\n");
        ASSERT_TRUE(mesh) << mesh.error().message();
        EXPECT_DOUBLE_EQ(reportOn(*mesh).area, 2) << face;
    }
}

TEST(ObjReader, RefusesAFaceThatCrossesItself) {
    EXPECT_EQ(parse("v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\n\nf 1 2 3 4\n").error().message(),
              "a.obj, line 6: the outline of the face crosses itself; repair or export the surface again.");
}

/// A tetrahedron of 20 mm far away, written to a thousandth of a millimetre.
std::string farAway(const Vec3& at, int digits = 3) {
    std::string text;
    for (const Vec3& corner : {Vec3(0.001, 0, 0), Vec3(20.001, 0, 0), Vec3(0.001, 20, 0), Vec3(0.001, 0, 20)}) {
        const Vec3 place = at + corner;
        text += "v " + rounded(place.x(), digits) + " " + rounded(place.y(), digits) + " " +
                rounded(place.z(), digits) + "\n";
    }
    return text + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
}

TEST(ObjReader, SubtractsAnOffsetBeforeItRoundsAndSaysSo) {
    for (const Vec3& at :
         {Vec3(1e6, 0, 0), Vec3(-1e6, 2e6, 5), Vec3(0, 0, 1e5 + 0.003), Vec3(1e7, 1e7, 1e7), Vec3(3e5, 0, 7)}) {
        const auto mesh = read(farAway(at));
        ASSERT_TRUE(mesh) << mesh.error().message();
        EXPECT_NEAR(reportOn(mesh->mesh).signedVolume, 8000.0 / 6, 1e-3);
        EXPECT_NEAR((mesh->mesh.vertices[0].cast<double>() + mesh->offset - at - Vec3(0.001, 0, 0)).norm(), 0, 1e-5);
        ASSERT_EQ(mesh->importNotes.size(), 1u);
        EXPECT_THAT(inWords(mesh->importNotes[0]), HasSubstr("were subtracted from its coordinates"));
    }
}

TEST(ObjReader, WhatLiesNearKeepsItsPlace) {
    for (const Vec3& at : {Vec3(0, 0, 0), Vec3(100, -200, 3000), Vec3(5000, 0, 0)}) {
        const auto mesh = parse(farAway(at));
        ASSERT_TRUE(mesh);
        EXPECT_EQ(mesh->vertices[0], (at + Vec3(0.001, 0, 0)).cast<float>());
    }
}

TEST(ObjReader, AFaceThatOnlyRoundingMakesCrossItselfIsReadWithAnOffset) {
    const auto mesh = read(
        "v 1000000.00 0 0\nv 1000000.30 0 0\nv 1000000.30 0.3 0\nv 1000000.21 0.3 0\nv 1000000.20 0.1 0\n"
        "v 1000000.19 0.3 0\nv 1000000.00 0.3 0\nf 1 2 3 4 5 6 7\n");
    ASSERT_TRUE(mesh) << mesh.error().message();
    EXPECT_NEAR(reportOn(mesh->mesh).area, 0.09 - 0.002, 1e-6);
}

}  // namespace
}  // namespace tactooth
