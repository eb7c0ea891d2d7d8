// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/io/stl_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

#include "geometry/io/stl_reader.h"
#include "geometry/stl_bytes.h"
#include "support/shapes.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

using test::coordinateBits;

/// Triangles with random bits in every finite coordinate: tiny, huge, subnormal.
TriangleMesh randomBitsMesh() {
    std::mt19937 random(20260102);
    TriangleMesh mesh;
    for (std::uint32_t vertex = 0; vertex < 3000; ++vertex) {
        Vec3f position;
        for (float& coordinate : position) {
            do {
                coordinate = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
            } while (!std::isfinite(coordinate));
        }
        mesh.vertices.push_back(position);
        if (vertex % 3 == 2) mesh.triangles.push_back({vertex - 2, vertex - 1, vertex});
    }
    return mesh;
}

class StlWriterFormats : public ::testing::TestWithParam<StlFormat> {};

TEST_P(StlWriterFormats, EveryCoordinateComesBackBitForBit) {
    for (const TriangleMesh& mesh : {randomBitsMesh(), test::sphere(Vec3(1, -2, 3), 4.2, 24, 12)}) {
        const Expected<TriangleMesh> back = parseStl(stlBytes(mesh, GetParam()), "memory");
        ASSERT_TRUE(back) << back.error().message();
        EXPECT_EQ(coordinateBits(*back), coordinateBits(mesh));
    }
}

TEST_P(StlWriterFormats, DegenerateTrianglesComeBackInTheirPlace) {
    TriangleMesh mesh = test::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    mesh.triangles.insert(mesh.triangles.begin() + 5, Triangle{3, 3, 4});
    const Expected<TriangleMesh> back = parseStl(stlBytes(mesh, GetParam()), "memory");
    ASSERT_TRUE(back) << back.error().message();
    EXPECT_EQ(coordinateBits(*back), coordinateBits(mesh));
}

INSTANTIATE_TEST_SUITE_P(Stl, StlWriterFormats, ::testing::Values(StlFormat::Binary, StlFormat::Ascii),
                         [](const auto& format) { return format.param == StlFormat::Binary ? "Binary" : "Ascii"; });

TEST(StlWriter, BinaryRecordsHoldTheOutwardNormal) {
    const std::vector<std::byte> bytes = stlBytes(test::box(Vec3(0, 0, 0), Vec3(1, 2, 3)));
    ASSERT_EQ(bytes.size(), 84U + 12U * 50U);
    std::array<float, 3> normal;
    std::memcpy(normal.data(), bytes.data() + 84, sizeof normal);
    EXPECT_EQ(normal, (std::array<float, 3>{0, 0, -1}));  // the box begins with its floor
}

TEST(StlWriter, BinaryHeaderIsNotMistakenForText) {
    const std::vector<std::byte> bytes = stlBytes(test::box(Vec3(0, 0, 0), Vec3(1, 1, 1)));
    const std::string header(reinterpret_cast<const char*>(bytes.data()), 80);
    EXPECT_THAT(header, ::testing::StartsWith("Tactooth"));
}

TEST(StlWriter, WritesAFileThatReadsBack) {
    const test::TemporaryFolder folder;
    const TriangleMesh mesh = test::cylinder(Vec3(0, 0, 0), 0.6, 4, 16);
    ASSERT_TRUE(writeStl(mesh, folder / "bur.stl"));
    const Expected<TriangleMesh> back = readStl(folder / "bur.stl");
    ASSERT_TRUE(back) << back.error().message();
    EXPECT_EQ(coordinateBits(*back), coordinateBits(mesh));
}

TEST(StlWriter, AMissingFolderIsAnErrorThatNamesTheFile) {
    const test::TemporaryFolder folder;
    const Expected<void> written = writeStl(test::box(Vec3(0, 0, 0), Vec3(1, 1, 1)), folder / "no" / "such.stl");
    ASSERT_FALSE(written);
    EXPECT_THAT(written.error().message(),
                ::testing::HasSubstr("such.stl: cannot be written: its folder does not exist"));
}

}  // namespace
}  // namespace tactooth
