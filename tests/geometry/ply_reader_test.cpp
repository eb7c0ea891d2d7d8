// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/ply_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>

#include "geometry/mesh_report.h"

namespace tactooth {
namespace {

using ::testing::HasSubstr;

Expected<TriangleMesh> parse(const std::string& bytes) { return parsePly(std::as_bytes(std::span(bytes)), "a.ply"); }

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
        ASSERT_TRUE(mesh) << mesh.error().message;
        EXPECT_TRUE(reportOn(*mesh).watertight());
        EXPECT_NEAR(reportOn(*mesh).signedVolume, 1.0 / 6, 1e-6);
    }
}

TEST(PlyReader, SplitsPolygons) {
    const auto mesh = parse(header("ascii", "4", "1") + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
    ASSERT_TRUE(mesh) << mesh.error().message;
    EXPECT_EQ(mesh->triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(PlyReader, RefusesWhatIsCutShort) {
    const std::string whole = binary(false);
    for (std::size_t length = 0; length < whole.size(); ++length) EXPECT_FALSE(parse(whole.substr(0, length)));
}

TEST(PlyReader, DoesNotBelieveHugeClaims) {
    const std::string most = "18446744073709551615";
    EXPECT_THAT(parse(header("ascii", most, "4") + kBody).error().message, HasSubstr("vertex"));
    EXPECT_THAT(parse("ply\nformat ascii 1.0\nelement nothing " + most + "\nend_header\n").error().message,
                HasSubstr("no faces"));
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\nelement face 1\nproperty list uint int vertex_indices\n"
        "end_header\n";
    add(bytes, 4'000'000'000U, false);
    EXPECT_THAT(parse(bytes).error().message, HasSubstr("longer than the file"));
}

TEST(PlyReader, RefusesCornersThatAreNotThere) {
    EXPECT_THAT(parse(header("ascii", "3", "1") + "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n").error().message,
                HasSubstr("face 1: a corner names a vertex that the file does not have"));
}

TEST(PlyReader, NamesTheLineOfTheHeaderThatIsWrong) {
    EXPECT_THAT(parse("ply\nformat ascii 2.0\n").error().message, HasSubstr("a.ply, line 2"));
    EXPECT_THAT(parse("ply\nformat ascii 1.0\nsurprise\n").error().message, HasSubstr("'surprise'"));
    EXPECT_THAT(parse("ply\nelement vertex 3\nend_header\n").error().message, HasSubstr("names no format"));
}

}  // namespace
}  // namespace tactooth
