// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/io/stl_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <clocale>
#include <fstream>
#include <limits>
#include <random>

#include "geometry/stl_bytes.h"
#include "geometry/util/byte_text.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

using test::binaryStl;
using test::kTetrahedron;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr std::string_view kAsciiTriangle =
    "solid one\n"
    " facet normal 0 0 1\n"
    "  outer loop\n"
    "   vertex 0 0 0\n"
    "   vertex 1.5 0 0\n"
    "   vertex 0 2.5e-1 0\n"
    "  endloop\n"
    " endfacet\n"
    "endsolid one\n";

std::string replaced(std::string_view text, std::string_view what, std::string_view with) {
    std::string result(text);
    for (std::size_t at = 0; (at = result.find(what, at)) != result.npos; at += with.size()) {
        result.replace(at, what.size(), with);
    }
    return result;
}

TriangleMesh parsed(std::string_view bytes) {
    Expected<TriangleMesh> mesh = parseStl(asBytes(bytes), "t.stl");
    EXPECT_TRUE(mesh) << mesh.error().message();
    return mesh ? *mesh : TriangleMesh{};
}

/// The error for `bytes`, or "accepted".
std::string refusal(std::string_view bytes) {
    const Expected<TriangleMesh> mesh = parseStl(asBytes(bytes), "t.stl");
    return mesh ? "accepted" : mesh.error().message();
}

std::string refusalOfFile(const std::filesystem::path& path) {
    const Expected<TriangleMesh> mesh = readStl(path);
    return mesh ? "accepted" : mesh.error().message();
}

void expectTheAsciiTriangle(const TriangleMesh& mesh) {
    ASSERT_EQ(mesh.triangles.size(), 1U);
    EXPECT_EQ(mesh.triangles[0], (Triangle{0, 1, 2}));
    ASSERT_EQ(mesh.vertices.size(), 3U);
    EXPECT_EQ(mesh.vertices[0], Vec3f(0, 0, 0));
    EXPECT_EQ(mesh.vertices[1], Vec3f(1.5F, 0, 0));
    EXPECT_EQ(mesh.vertices[2], Vec3f(0, 0.25F, 0));
}

TEST(StlReader, BinaryTetrahedronHasFourTrianglesAndFourVertices) {
    const TriangleMesh mesh = parsed(binaryStl("made by hand", 4, kTetrahedron));
    EXPECT_EQ(mesh.triangles.size(), 4U);
    EXPECT_EQ(mesh.vertices.size(), 4U);
    EXPECT_EQ(mesh.triangles[0], (Triangle{0, 1, 2}));
    EXPECT_EQ(mesh.triangles[3], (Triangle{2, 1, 3}));
}

TEST(StlReader, BinaryFileWhoseHeaderBeginsWithSolidIsBinary) {
    EXPECT_EQ(parsed(binaryStl("solid exported by some program", 4, kTetrahedron)).triangles.size(), 4U);
}

TEST(StlReader, BinaryNormalsAndAttributesAreIgnored) {
    std::string bytes = binaryStl("", 4, kTetrahedron);
    const float notANumber = std::numeric_limits<float>::quiet_NaN();
    bytes.replace(84, sizeof notANumber, reinterpret_cast<const char*>(&notANumber), sizeof notANumber);
    bytes.replace(84 + 48, 2, "\xff\x7f");
    EXPECT_EQ(parsed(bytes).triangles, parsed(binaryStl("", 4, kTetrahedron)).triangles);
}

TEST(StlReader, AsciiTriangleIsRead) { expectTheAsciiTriangle(parsed(kAsciiTriangle)); }

TEST(StlReader, AsciiWithWindowsLineEndsIsRead) {
    expectTheAsciiTriangle(parsed(replaced(kAsciiTriangle, "\n", "\r\n")));
}

TEST(StlReader, AsciiWithOldMacLineEndsIsRead) { expectTheAsciiTriangle(parsed(replaced(kAsciiTriangle, "\n", "\r"))); }

TEST(StlReader, AsciiKeywordsMayBeCapitals) {
    const std::string text = replaced(replaced(kAsciiTriangle, "vertex", "VERTEX"), "solid", "Solid");
    expectTheAsciiTriangle(parsed(text));
}

TEST(StlReader, AsciiWithByteOrderMarkAndLeadingBlanksIsRead) {
    expectTheAsciiTriangle(parsed("\xEF\xBB\xBF \r\n\t" + std::string(kAsciiTriangle)));
}

TEST(StlReader, AsciiSolidNameMayBeAnyText) {
    expectTheAsciiTriangle(parsed(replaced(kAsciiTriangle, "solid one", "solid Бур facet vertex №1 \xE7\x89\x99")));
    expectTheAsciiTriangle(parsed(replaced(kAsciiTriangle, "solid one", "solid")));
}

TEST(StlReader, AsciiNumbersMayBeScientificAndSigned) {
    const TriangleMesh mesh = parsed(replaced(kAsciiTriangle, "1.5 0 0", "+1.5E+02 -2.5e-3 .5"));
    EXPECT_EQ(mesh.vertices[1], Vec3f(150.0F, -0.0025F, 0.5F));
}

TEST(StlReader, AsciiNumberTooSmallForAFloatIsZero) {
    EXPECT_EQ(parsed(replaced(kAsciiTriangle, "1.5 0 0", "1 1e-60 -1E-999")).vertices[1], Vec3f(1, 0, 0));
}

TEST(StlReader, AsciiNormalMayBeAnything) {
    expectTheAsciiTriangle(parsed(replaced(kAsciiTriangle, "normal 0 0 1", "normal nan -1.#IND 1.#QNAN")));
}

TEST(StlReader, SeveralAsciiSolidsBecomeOneMeshInTheirOrder) {
    const TriangleMesh mesh =
        parsed(std::string(kAsciiTriangle) + replaced(kAsciiTriangle, "vertex 1.5 0 0", "vertex 7 0 0"));
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 3, 2}}));
    EXPECT_EQ(mesh.vertices[3], Vec3f(7, 0, 0));
}

TEST(StlReader, NumbersDoNotDependOnTheLocale) {
    // LC_NUMERIC with a decimal comma, where the machine has such a locale; std::from_chars must not care.
    const char* changed = std::setlocale(LC_NUMERIC, "de_DE.UTF-8");
    const TriangleMesh mesh = parsed(kAsciiTriangle);
    std::setlocale(LC_NUMERIC, "C");
    expectTheAsciiTriangle(mesh);
    RecordProperty("locale", changed != nullptr ? changed : "none with a decimal comma");
}

TEST(StlReader, DegenerateTrianglesStayInTheirPlace) {
    auto triangles = kTetrahedron;
    triangles.insert(triangles.begin() + 1, {{1, 1, 1, 1, 1, 1, 2, 2, 2}});
    const TriangleMesh mesh = parsed(binaryStl("", 5, triangles));
    ASSERT_EQ(mesh.triangles.size(), 5U);
    EXPECT_EQ(mesh.triangles[1], (Triangle{3, 3, 4}));
}

TEST(StlReader, RefusesATruncatedBinaryFile) {
    std::string bytes = binaryStl("", 4, kTetrahedron);
    bytes.resize(200);
    EXPECT_THAT(refusal(bytes), AllOf(StartsWith("t.stl: the file is cut short"), HasSubstr("announces 4 triangles"),
                                      HasSubstr("284 bytes"), HasSubstr("the file has 200")));
}

TEST(StlReader, RefusesEveryTruncationOfABinaryFile) {
    const std::string bytes = binaryStl("x", 4, kTetrahedron);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        EXPECT_THAT(refusal(bytes.substr(0, size)), AllOf(StartsWith("t.stl: "), EndsWith("."))) << size;
    }
}

TEST(StlReader, RefusesEveryTruncationOfAnAsciiFileBeforeItsLastWord) {
    const std::size_t complete = kAsciiTriangle.rfind("endsolid") + 8;
    for (std::size_t size = 0; size < complete; ++size) {
        EXPECT_THAT(refusal(kAsciiTriangle.substr(0, size)), AllOf(StartsWith("t.stl"), EndsWith("."))) << size;
    }
    expectTheAsciiTriangle(parsed(kAsciiTriangle.substr(0, complete)));
}

TEST(StlReader, RefusesBytesBehindTheLastTriangle) {
    EXPECT_THAT(refusal(binaryStl("", 4, kTetrahedron) + "more"), HasSubstr("longer than its triangle count says"));
}

TEST(StlReader, AHugeCountDoesNotAllocate) {
    EXPECT_THAT(refusal(binaryStl("", 0xffffffffU, kTetrahedron)),
                AllOf(HasSubstr("cut short or its count is wrong"), HasSubstr("4294967295 triangles")));
}

TEST(StlReader, RefusesFilesWithoutTriangles) {
    EXPECT_THAT(refusal(binaryStl("", 0, {})), HasSubstr("holds no triangles"));
    EXPECT_THAT(refusal("solid empty\nendsolid empty\n"), HasSubstr("holds no triangles"));
}

TEST(StlReader, RefusesCoordinatesThatAreNotFinite) {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity()}) {
        auto triangles = kTetrahedron;
        triangles[2][5] = bad;
        EXPECT_THAT(refusal(binaryStl("", 4, triangles)),
                    AllOf(HasSubstr("triangle 3 (byte 196)"), HasSubstr("not a finite number")));
    }
    std::vector<std::array<float, 9>> many(50, kTetrahedron[0]);
    many[40][0] = std::numeric_limits<float>::infinity();
    EXPECT_THAT(refusal(binaryStl("", 50, many)), HasSubstr("triangle 41 (byte 2096)"));
    for (const char* bad : {"nan", "inf", "-inf", "1e39", "1e999"}) {
        EXPECT_THAT(refusal(replaced(kAsciiTriangle, "1.5 0 0", std::string("1.5 ") + bad + " 0")),
                    AllOf(HasSubstr("line 5"), HasSubstr("finite coordinate"), HasSubstr(bad)));
    }
}

TEST(StlReader, RefusesTextGarbageWithLineAndWord) {
    EXPECT_EQ(refusal(replaced(kAsciiTriangle, "   vertex 1.5", "   vertx 1.5")),
              "t.stl, line 5: expected 'vertex', but found 'vertx'; repair or export the surface again.");
    EXPECT_THAT(refusal(replaced(kAsciiTriangle, "1.5", "1,5")), AllOf(HasSubstr("line 5"), HasSubstr("'1,5'")));
    EXPECT_THAT(refusal(replaced(kAsciiTriangle, "  endloop", "vertex 1 1 1\n endloop")),
                HasSubstr("expected 'endloop'"));
    EXPECT_THAT(refusal(std::string(kAsciiTriangle) + "and more"), HasSubstr("line 10: expected 'solid' or the end"));
}

TEST(StlReader, MessagesShowNoControlCharactersOfTheFile) {
    const std::string message =
        refusal(replaced(kAsciiTriangle, "endloop", "\x1b[31m" + std::string(600, 'x') + "\x07"));
    EXPECT_LT(message.size(), 200U);
    EXPECT_EQ(message.find('\x1b'), message.npos);
}

TEST(StlReader, RefusesWhatIsNotStl) {
    EXPECT_THAT(refusal("just some text\n"), HasSubstr("text that does not begin with 'solid'"));
    EXPECT_THAT(refusal("ply\nformat ascii 1.0\n"), HasSubstr("a PLY mesh"));
    EXPECT_THAT(refusal("\x89PNG\r\n\x1a\n" + std::string(500, '\xf7')), HasSubstr("a PNG picture"));
    std::mt19937 random(20260104);
    std::string noise(500, '\0');
    for (char& byte : noise) byte = static_cast<char>(random());
    EXPECT_THAT(refusal(noise), HasSubstr("unknown binary data"));
    EXPECT_THAT(refusal(std::string("a\0b", 3)), HasSubstr("too short"));
    EXPECT_THAT(refusal(""), HasSubstr("is empty"));
}

TEST(StlReader, RefusesAnEmptyFileAFolderAndAMissingFile) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "empty.stl").close();
    EXPECT_EQ(refusalOfFile(folder / "empty.stl"),
              (folder / "empty.stl").string() + ": the file is empty; export or copy it again.");
    EXPECT_THAT(refusalOfFile(folder.path()), HasSubstr("this is a folder"));
    EXPECT_THAT(refusalOfFile(folder / "missing.stl"), HasSubstr("there is no such file"));
    EXPECT_THAT(refusalOfFile(folder / "empty.stl" / "x.stl"), HasSubstr("there is no such file"));
}

TEST(StlReader, RefusesAPipeWithoutWaiting) {
    const test::TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe.stl").c_str(), 0600), 0);
    EXPECT_THAT(refusalOfFile(folder / "pipe.stl"), HasSubstr("not a regular file"));
}

TEST(StlReader, RefusesAFileThatTheUserMayNotRead) {
    const test::TemporaryFolder folder;
    std::filesystem::permissions(folder.path(), std::filesystem::perms::all);
    std::ofstream(folder / "locked.stl") << "solid";
    std::filesystem::permissions(folder / "locked.stl", std::filesystem::perms::none);
    constexpr uid_t kNobody = 65534;  // root may read everything, so the test changes its user for a moment
    const bool steppedDown = ::geteuid() == 0 && ::seteuid(kNobody) == 0;
    const std::string message = refusalOfFile(folder / "locked.stl");
    ASSERT_TRUE(!steppedDown || ::seteuid(0) == 0);
    EXPECT_THAT(message, HasSubstr("this user may not read the file"));
}

TEST(StlReader, ReadsAFileWithANonAsciiName) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "Моляр 牙.stl", std::ios::binary) << binaryStl("", 4, kTetrahedron);
    const Expected<TriangleMesh> mesh = readStl(folder / "Моляр 牙.stl");
    ASSERT_TRUE(mesh) << mesh.error().message();
    EXPECT_EQ(mesh->triangles.size(), 4U);
}

}  // namespace
}  // namespace tactooth
