// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "patient/scan_import.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

#include "geometry/mesh/mesh_report.h"
#include "instruments/builtin_tooth.h"
#include "support/materials.h"

namespace tactooth {
namespace {

const BuiltinTooth& molar() {
    static const BuiltinTooth tooth = makeTooth({.fdi = 36, .triangles = 3000, .seed = 0, .lesion = {}});
    return tooth;
}

TriangleMesh scaled(TriangleMesh mesh, float factor) {
    for (Vec3f& vertex : mesh.vertices) vertex *= factor;
    return mesh;
}

std::string allWords(const ExaminedScan& scan) {
    std::string words;
    for (const ImportNote& importNote : scan.importNotes) words += inWords(importNote) + "\n";
    return words;
}

TEST(ScanImport, ASoundToothInMillimetresStaysAsItIs) {
    const auto scan = examineScan({"t", molar().outer, {}}, {});
    ASSERT_TRUE(scan);
    EXPECT_EQ(scan->mmPerUnit, 1);
    EXPECT_EQ(scan->outer.triangles, molar().outer.triangles);
    EXPECT_NE(allWords(*scan).find("closed and sound as it came"), std::string::npos) << allWords(*scan);
}

TEST(ScanImport, EveryUnitGivesTheSameTooth) {
    for (const float factor : {0.1F, 1000.0F, 0.001F, 23.0F}) {
        const auto scan = examineScan({"t", scaled(molar().outer, factor), {}}, {});
        ASSERT_TRUE(scan);
        EXPECT_NEAR(boundingBox(scan->outer).sizes().z(), boundingBox(molar().outer).sizes().z(), 1) << factor;
    }
}

TEST(ScanImport, ATurnedToothStandsUp) {
    const Pose lying{Vec3(40, 0, 3), Quat(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitX()))};
    const auto scan = examineScan({"t", transformed(molar().outer, lying), {}}, {});
    ASSERT_TRUE(scan);
    EXPECT_NEAR(boundingBox(scan->outer).max().z(), boundingBox(molar().outer).max().z(), 2.5);
}

TEST(ScanImport, DamageIsMendedAndSaid) {
    TriangleMesh damaged = molar().outer;
    std::swap(damaged.triangles[7][0], damaged.triangles[7][1]);
    damaged.triangles.push_back(damaged.triangles[20]);
    damaged.triangles.erase(damaged.triangles.begin() + 500);
    const auto scan = examineScan({"t", damaged, {}}, {});
    ASSERT_TRUE(scan);
    EXPECT_TRUE(reportOn(scan->outer).watertight());
    const std::string words = allWords(*scan);
    EXPECT_NE(words.find("1 empty or doubled triangles were dropped"), std::string::npos) << words;
    EXPECT_NE(words.find("1 triangles were turned"), std::string::npos) << words;
    EXPECT_NE(words.find("1 holes were filled"), std::string::npos) << words;
}

/// The crown alone, as an intraoral scanner sees it: open at the gingiva.
TriangleMesh crownOnly() {
    TriangleMesh crown = molar().outer;
    std::erase_if(crown.triangles, [&](const Triangle& t) {
        return std::ranges::any_of(t, [&](std::uint32_t v) { return crown.vertices[v].z() < 0; });
    });
    return crown;
}

TEST(ScanImport, AWideHoleIsFilledOnlyWhenAskedFor) {
    const auto refused = examineScan({"crown.stl", crownOnly(), {}}, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message().rfind("crown.stl: the surface 'outer' has 1 holes that are too wide", 0), 0u)
        << refused.error().message();
    ImportOptions all;
    all.holes = HolesToFill::All;
    const auto scan = examineScan({"crown.stl", crownOnly(), {}}, all);
    ASSERT_TRUE(scan);
    EXPECT_TRUE(reportOn(scan->outer).watertight());
    const auto tooth = finishScan(*scan, all);
    ASSERT_TRUE(tooth) << tooth.error().message();
}

TEST(ScanImport, LayersWithoutAnOuterSurfaceGetOne) {
    // The enamel of the built-in tooth is the whole crown: enamel and dentin overlap.
    const auto scan = examineScan(
        {"t", {}, {{"enamel", test::kEnamel, molar().enamel}, {"dentin", test::kDentin, molar().dentin}}}, {});
    ASSERT_TRUE(scan);
    EXPECT_NEAR(reportOn(scan->outer).signedVolume / reportOn(molar().outer).signedVolume, 1, 0.1);
    const auto tooth = finishScan(*scan, {});
    ASSERT_TRUE(tooth);
    EXPECT_FALSE(tooth->layersAreModelled);
    EXPECT_EQ(tooth->layers.size(), 2u);
}

TEST(ScanImport, AModelIsCalledAModel) {
    const auto scan = examineScan({"t", molar().outer, {}}, {});
    ASSERT_TRUE(scan);
    const auto tooth = finishScan(*scan, {});
    ASSERT_TRUE(tooth);
    EXPECT_TRUE(tooth->layersAreModelled);
    EXPECT_NE(allWords(*tooth).find("no measurement of this tooth"), std::string::npos);
}

TEST(ScanImport, ASpeckFarAwayChangesNeitherUnitNorFrame) {
    const auto expected = examineScan({"t", molar().outer, {}}, {});
    for (const float far : {30.0F, -200.0F, 1e5F}) {
        for (const bool isThin : {false, true}) {
            TriangleMesh mesh = molar().outer;
            const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
            mesh.vertices.insert(mesh.vertices.end(), {Vec3f(far, 0, 0), Vec3f(far, isThin ? 1e-3F : 0.3F, 0),
                                                       Vec3f(isThin ? far / 2 : far, 0.2F, 0.1F)});
            mesh.triangles.insert(mesh.triangles.begin(), {first, first + 1, first + 2});
            const auto scan = examineScan({"t", mesh, {}}, {});
            ASSERT_TRUE(scan) << scan.error().message();
            EXPECT_EQ(scan->mmPerUnit, 1);
            EXPECT_TRUE(boundingBox(scan->outer).isApprox(boundingBox(expected->outer))) << far;
            EXPECT_EQ(allWords(*scan).find("closed and sound as it came"), std::string::npos);
        }
    }
}

TEST(ScanImport, HolesThatShareCornersAreFilled) {
    // Around a vertex every second triangle is missing: the holes meet there.
    for (const std::uint32_t vertex : {100u, 400u, 700u, 1000u, 1300u}) {
        TriangleMesh mesh = molar().outer;
        std::size_t around = 0, gone = 0;
        std::erase_if(mesh.triangles, [&](const Triangle& t) {
            const bool isAdjacent = std::ranges::find(t, vertex) != t.end();
            return isAdjacent && around++ % 2 == 0 && ++gone > 0;
        });
        ASSERT_GE(gone, 2u);
        const auto scan = examineScan({"t", mesh, {}}, {.holes = HolesToFill::All});
        ASSERT_TRUE(scan) << scan.error().message();
        EXPECT_TRUE(reportOn(scan->outer).watertight());
    }
}

TEST(ScanImport, TheAdviceIsNotTheOneThatWasFollowed) {
    // A flap on an edge of the surface: not a hole to fill.
    TriangleMesh mesh = molar().outer;
    mesh.triangles.push_back({mesh.triangles[0][0], mesh.triangles[0][1], mesh.triangles[900][0]});
    const auto scan = examineScan({"t", mesh, {}}, {.holes = HolesToFill::All});
    ASSERT_FALSE(scan);
    EXPECT_EQ(scan.error().message().find("ask for all holes"), std::string::npos) << scan.error().message();
    EXPECT_TRUE(scan.error().message().ends_with('.'));
}

TEST(ScanImport, LooseTrianglesAreRefusedInTime) {
    std::mt19937 random(2);
    std::uniform_real_distribution<float> place(-10, 10);
    TriangleMesh mesh;
    constexpr std::uint32_t kCorners = 60000;
    for (std::uint32_t v = 0; v < kCorners; ++v)
        mesh.vertices.emplace_back(place(random), place(random), place(random));
    for (std::uint32_t v = 0; v < kCorners; v += 3) mesh.triangles.push_back({v, v + 1, v + 2});
    for (const HolesToFill holes : {HolesToFill::None, HolesToFill::Small, HolesToFill::All}) {
        const auto scan = examineScan({"t", mesh, {}}, {.holes = holes});
        ASSERT_FALSE(scan);
        EXPECT_TRUE(scan.error().message().ends_with('.')) << scan.error().message();
    }
}

TEST(ScanImport, BodiesThatReachIntoEachOtherAreRefused) {
    TriangleMesh mesh = molar().outer;
    for (Vec3f vertex : molar().outer.vertices) mesh.vertices.push_back(vertex + Vec3f(3, 1, 0));
    const auto count = static_cast<std::uint32_t>(molar().outer.vertices.size());
    for (const auto& [a, b, c] : molar().outer.triangles) mesh.triangles.push_back({a + count, b + count, c + count});
    const auto scan = examineScan({"t", mesh, {}}, {});
    ASSERT_FALSE(scan);
    EXPECT_NE(scan.error().message().find("reach into each other"), std::string::npos) << scan.error().message();
}

TEST(ScanImport, NothingIsRefused) {
    EXPECT_EQ(examineScan({"void", {}, {}}, {}).error().message(), "void: there is no surface.");
}

}  // namespace
}  // namespace tactooth
