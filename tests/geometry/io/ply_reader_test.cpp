// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/io/ply_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>

#include "geometry/mesh/mesh_report.h"

namespace tactooth {
namespace {

using ::testing::HasSubstr;

Expected<ReadMesh> read(const std::string& bytes) { return parsePly(std::as_bytes(std::span(bytes)), "a.ply"); }

Expected<TriangleMesh> parse(const std::string& bytes) {
    auto mesh = read(bytes);
    if (!mesh) return Unexpected{mesh.error()};
    return std::move(mesh->mesh);
}

std::string header(const std::string& format, const std::string& vertices, const std::string& faces,
                   const std::string& more = "") {
    return "ply\nformat " + format + " 1.0\ncomment by hand\nelement vertex " + vertices +
           "\nproperty float x\nproperty float y\nproperty float z\n" + more + "element face " + faces +
           "\nproperty list uchar int vertex_indices\nend_header\n";
}

const std::string kBody = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

template <class Number>
void add(std::string& bytes, Number value, bool bigEndian) {
    std::array<char, sizeof(Number)> raw;
    std::memcpy(raw.data(), &value, raw.size());
    if (bigEndian) std::reverse(raw.begin(), raw.end());
    bytes.append(raw.data(), raw.size());
}

std::string binary(bool bigEndian) {
    std::string bytes =
        header(bigEndian ? "binary_big_endian" : "binary_little_endian", "4", "4", "property uchar red\n");
    for (const auto& v : {std::array{0.F, 0.F, 0.F}, {1.F, 0.F, 0.F}, {0.F, 1.F, 0.F}, {0.F, 0.F, 1.F}}) {
        for (const float coordinate : v) add(bytes, coordinate, bigEndian);
        bytes += '\7';
    }
    for (const auto& f : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
        bytes += '\3';
        for (const int corner : f) add(bytes, corner, bigEndian);
    }
    return bytes;
}

TEST(PlyReader, ReadsAsciiAndBothByteOrders) {
    for (const std::string& bytes : {header("ascii", "4", "4") + kBody, binary(false), binary(true)}) {
        const auto mesh = parse(bytes);
        ASSERT_TRUE(mesh) << mesh.error().message();
        EXPECT_TRUE(reportOn(*mesh).watertight());
        EXPECT_NEAR(reportOn(*mesh).signedVolume, 1.0 / 6, 1e-6);
    }
}

TEST(PlyReader, SplitsPolygons) {
    const auto mesh = parse(header("ascii", "4", "1") + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
    ASSERT_TRUE(mesh) << mesh.error().message();
    EXPECT_EQ(mesh->triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(PlyReader, RefusesWhatIsCutShort) {
    const std::string whole = binary(false);
    for (std::size_t length = 0; length < whole.size(); ++length) EXPECT_FALSE(parse(whole.substr(0, length)));
}

TEST(PlyReader, DoesNotBelieveHugeClaims) {
    const std::string most = "18446744073709551615";
    EXPECT_THAT(parse(header("ascii", most, "4") + kBody).error().message(), HasSubstr("vertex"));
    EXPECT_THAT(parse("ply\nformat ascii 1.0\nelement nothing " + most + "\nend_header\n").error().message(),
                HasSubstr("no faces"));
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\nelement face 1\nproperty list uint int vertex_indices\n"
        "end_header\n";
    add(bytes, 4'000'000'000U, false);
    EXPECT_THAT(parse(bytes).error().message(), HasSubstr("longer than the file"));
}

TEST(PlyReader, RefusesCornersThatAreNotThere) {
    EXPECT_THAT(parse(header("ascii", "3", "1") + "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n").error().message(),
                HasSubstr("face 1: a corner names a vertex that the file does not have"));
}

TEST(PlyReader, NamesTheLineOfTheHeaderThatIsWrong) {
    EXPECT_THAT(parse("ply\nformat ascii 2.0\n").error().message(), HasSubstr("a.ply, line 2"));
    EXPECT_THAT(parse("ply\nformat ascii 1.0\nsurprise\n").error().message(), HasSubstr("'surprise'"));
    EXPECT_THAT(parse("ply\nelement vertex 3\nend_header\n").error().message(), HasSubstr("names no format"));
}

/// With other line ends in the header.
std::string withLineEnds(const std::string& bytes, const std::string& end) {
    const std::string last = "end_header\n";
    const std::size_t data = bytes.find(last) + last.size();
    std::string result;
    for (const char letter : bytes.substr(0, data)) result += letter == '\n' ? end : std::string(1, letter);
    return result + bytes.substr(data);
}

TEST(PlyReader, LinesMayEndInAnyWay) {
    for (const std::string& bytes : {header("ascii", "4", "4") + kBody, binary(false), binary(true)}) {
        for (const char* const end : {"\n", "\r\n", "\r"}) {
            for (const char* const mark : {"", "\xEF\xBB\xBF"}) {
                const auto mesh = parse(mark + withLineEnds(bytes, end));
                ASSERT_TRUE(mesh) << mesh.error().message();
                EXPECT_NEAR(reportOn(*mesh).signedVolume, 1.0 / 6, 1e-6);
            }
        }
    }
    std::string body = kBody;
    std::ranges::replace(body, '\n', '\r');
    EXPECT_TRUE(parse(withLineEnds(header("ascii", "4", "4"), "\r") + body));
}

TEST(PlyReader, AFirstByteLikeALineFeedBelongsToTheData) {
    // The first coordinate's first byte is 0x0A: the header's lines end in CR alone.
    std::string bytes = withLineEnds(header("binary_little_endian", "3", "1"), "\r");
    for (const float x : {std::bit_cast<float>(0x3f80000aU), 0.F, 0.F, 2.F, 0.F, 0.F, 0.F, 1.F, 0.F})
        add(bytes, x, false);
    bytes += '\3';
    for (const int corner : {0, 1, 2}) add(bytes, corner, false);
    const auto mesh = parse(bytes);
    ASSERT_TRUE(mesh) << mesh.error().message();
    EXPECT_EQ(mesh->vertices[0].x(), std::bit_cast<float>(0x3f80000aU));
}

std::string strips(const std::string& type, const std::string& lists, int count = 1) {
    return "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
           "element tristrips " +
           std::to_string(count) + "\nproperty list int " + type +
           " vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n" + lists + "\n";
}

TEST(PlyReader, ReadsTriangleStrips) {
    const std::vector<Triangle> three = {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}};
    EXPECT_EQ(parse(strips("int", "5 0 1 2 3 4")).value().triangles, three);
    EXPECT_EQ(parse(strips("int", "8 0 1 2 -1 2 1 3 -1")).value().triangles,
              (std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}}));
    EXPECT_EQ(parse(strips("uint", "7 0 1 2 4294967295 2 1 3")).value().triangles,
              (std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}}));
    EXPECT_EQ(parse(strips("short", "3 0 1 2\n4 2 1 3 4", 2)).value().triangles,
              (std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}, {3, 1, 4}}));
    // Duplicate corners continue the strip, and the orientation still alternates.
    EXPECT_EQ(parse(strips("int", "7 0 1 2 2 2 1 3")).value().triangles.size(), 2u);
    EXPECT_GT(parse(strips("int", "7 0 1 2 2 2 1 3")).value().areaVector(1).z(), 0);
    EXPECT_EQ(parse(strips("int", "6 -1 -1 0 1 2 -1")).value().triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(PlyReader, RefusesStripsOfNothing) {
    EXPECT_THAT(parse(strips("int", "2 0 1")).error().message(), HasSubstr("no faces"));
    EXPECT_THAT(parse(strips("int", "3 0 1 -2")).error().message(),
                HasSubstr("'tristrips' 1: a corner names a vertex"));
    EXPECT_THAT(parse(strips("float", "3 0 1 0.5")).error().message(), HasSubstr("a corner names a vertex"));
}

TEST(PlyReader, SplitsFacesWithinTheirOutline) {
    const std::string arrow = header("ascii", "4", "1") + "0 0 0\n2 -2 0\n1 0 0\n2 2 0\n";
    for (const char* const face : {"4 0 1 2 3", "4 1 2 3 0", "4 2 3 0 1", "4 3 2 1 0", "5 0 1 2 3 3"}) {
        const auto mesh = parse(arrow + face + "\n");
        ASSERT_TRUE(mesh) << mesh.error().message();
        EXPECT_DOUBLE_EQ(reportOn(*mesh).area, 2) << face;
    }
    EXPECT_EQ(parse(header("ascii", "4", "1") + "0 0 0\n1 1 0\n1 0 0\n0 1 0\n4 0 1 2 3\n").error().message(),
              "a.ply: face 1: the outline of the face crosses itself; export the surface again.");
}

TEST(PlyReader, DoublesFarFromZeroLoseNothing) {
    const Vec3 at(1e6, -3e6, 12);
    std::string bytes = header("binary_little_endian", "4", "4");
    for (std::size_t place; (place = bytes.find("float")) != bytes.npos;) bytes.replace(place, 5, "double");
    for (const Vec3& corner : {Vec3(0.1, 0, 0), Vec3(20.1, 0, 0), Vec3(0.1, 20, 0), Vec3(0.1, 0, 20)}) {
        for (const double coordinate : Vec3(at + corner)) add(bytes, coordinate, false);
    }
    for (const auto& f : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
        bytes += '\3';
        for (const int corner : f) add(bytes, corner, false);
    }
    const auto mesh = read(bytes);
    ASSERT_TRUE(mesh) << mesh.error().message();
    EXPECT_EQ(mesh->offset, Vec3(1000010, -2999990, 20));
    EXPECT_NEAR(reportOn(mesh->mesh).signedVolume, 8000.0 / 6, 1e-3);
}

}  // namespace
}  // namespace tactooth
