// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/obj_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "geometry/mesh_report.h"

namespace tactooth {
namespace {

using ::testing::HasSubstr;

Expected<TriangleMesh> parse(const std::string& text) { return parseObj(std::as_bytes(std::span(text)), "a.obj"); }

const std::string kCorners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

TEST(ObjReader, ReadsATetrahedron) {
    const auto mesh = parse("# made by hand\no t\n" + kCorners + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    ASSERT_TRUE(mesh) << mesh.error().message;
    EXPECT_TRUE(reportOn(*mesh).watertight());
    EXPECT_NEAR(reportOn(*mesh).signedVolume, 1.0 / 6, 1e-6);
}

TEST(ObjReader, TakesTextureAndNormalNumbersAndCountsFromTheEnd) {
    const auto mesh =
        parse(kCorners + "vt 0 0\nvn 0 0 1\nf 1/1/1 3/1/1 2/1/1\r\nf 1//1 2//1 4//1\nf -3/1 -2/1 -1/1\nf 3 1 4\n");
    ASSERT_TRUE(mesh) << mesh.error().message;
    EXPECT_TRUE(reportOn(*mesh).watertight());
}

TEST(ObjReader, SplitsPolygonsAndWeldsEqualPositions) {
    const auto mesh = parse("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 0\nf 1 2 3 4\nf 5 2 3\n");
    ASSERT_TRUE(mesh) << mesh.error().message;
    EXPECT_EQ(mesh->triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}}));
    EXPECT_EQ(mesh->vertices.size(), 4u);
}

TEST(ObjReader, NamesTheLineThatIsWrong) {
    EXPECT_THAT(parse(kCorners + "f 1 2 5\n").error().message, HasSubstr("a.obj, line 5"));
    EXPECT_THAT(parse(kCorners + "f 1 2\n").error().message, HasSubstr("three corners"));
    EXPECT_THAT(parse("v 0 zero 0\n").error().message,
                HasSubstr("line 1: expected a finite coordinate, but found 'zero'"));
    EXPECT_THAT(parse("v 0 inf 0\n").error().message, HasSubstr("finite"));
    EXPECT_THAT(parse(kCorners + "f 0 1 2\n").error().message, HasSubstr("'0'"));
}

TEST(ObjReader, RefusesAFileWithoutFaces) {
    EXPECT_THAT(parse(kCorners).error().message, HasSubstr("holds no faces"));
    EXPECT_FALSE(parse(""));
}

}  // namespace
}  // namespace tactooth
