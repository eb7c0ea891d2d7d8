// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/permanent_teeth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <span>

#include "instruments/mesh_checks.h"
#include "support/materials.h"
#include "support/mesh_checks.h"
#include "support/sanitizer.h"

namespace tactooth {
namespace {

constexpr double kTolerance = 0.03;        // of each length
constexpr double kCervixTolerance = 0.05;  // of the neck's widths, which are measured across the curved cervical line
constexpr int kTriangles = 6000;

constexpr std::span<const test::AverageTooth> kTestedAverages =
    std::span(test::kAverageTeeth).first(test::cases<std::size_t>(16, 1));

const BuiltinTooth& toothOf(int fdi) {
    static std::map<int, BuiltinTooth> made;
    const auto [place, isNew] = made.try_emplace(fdi);
    if (isNew) place->second = makeTooth({fdi, kTriangles, 0, {}});
    return place->second;
}

Box3 crownBox(const TriangleMesh& mesh) {
    Box3 box;
    for (const Vec3f& v : mesh.vertices) {
        if (v.z() > 0) box.extend(v.cast<double>());
    }
    return box;
}

/// Extent of the cut at a height.
Box3 sliceAt(const TriangleMesh& mesh, double z) {
    Box3 box;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3 from = mesh.corner(i, corner), to = mesh.corner(i, (corner + 1) % 3);
            if ((from.z() < z) != (to.z() < z)) box.extend(from + (z - from.z()) / (to.z() - from.z()) * (to - from));
        }
    }
    return box;
}

class PermanentTooth : public testing::TestWithParam<test::AverageTooth> {
protected:
    const test::AverageTooth& average_ = GetParam();
    const BuiltinTooth& tooth_ = toothOf(GetParam().fdi);
};

TEST_P(PermanentTooth, HasTheLengthsOfTheAverageTooth) {
    const Box3 box = boundingBox(tooth_.outer);
    EXPECT_NEAR(box.max().z(), average_.crown, kTolerance * average_.crown);
    EXPECT_NEAR(-box.min().z(), average_.root, kTolerance * average_.root);
}

TEST_P(PermanentTooth, HasTheCrownDiametersOfTheAverageTooth) {
    const Vec3 size = crownBox(tooth_.outer).sizes();
    EXPECT_NEAR(size.x(), average_.mesiodistal, kTolerance * average_.mesiodistal);
    EXPECT_NEAR(size.y(), average_.faciolingual, kTolerance * average_.faciolingual);
}

TEST_P(PermanentTooth, HasTheNeckOfTheAverageTooth) {
    const Box3 mesial = sliceAt(tooth_.outer, average_.mesialRise), distal = sliceAt(tooth_.outer, average_.distalRise);
    const bool mesialIsPlus = mesialX(tooth_.fdi) > 0;
    const double width = mesialIsPlus ? mesial.max().x() - distal.min().x() : distal.max().x() - mesial.min().x();
    EXPECT_NEAR(width, average_.cervixMesiodistal, kCervixTolerance * average_.cervixMesiodistal);
    EXPECT_NEAR(sliceAt(tooth_.outer, 0).sizes().y(), average_.cervixFaciolingual,
                kCervixTolerance * average_.cervixFaciolingual);
}

TEST_P(PermanentTooth, HasSoundNestedLayers) {
    test::expectValidLayers(tooth_);
    test::expectNestedLayers(tooth_);
}

TEST_P(PermanentTooth, IsSoundInAnotherMouthToo) {
    const BuiltinTooth other = makeTooth({average_.fdi, kTriangles, static_cast<std::uint32_t>(average_.fdi), {}});
    test::expectValidLayers(other);
    test::expectNestedLayers(other);
    EXPECT_FALSE(test::areBitEqual(other.outer, tooth_.outer));
}

TEST_P(PermanentTooth, HasItsMirrorImageOnTheOtherSide) {
    const int left = average_.fdi + (average_.fdi < 20 ? 10 : -10);
    const BuiltinTooth other = makeTooth({left, kTriangles, 0, {}});
    ASSERT_EQ(other.outer.vertices.size(), tooth_.outer.vertices.size());
    for (std::size_t i = 0; i < other.outer.vertices.size(); ++i) {
        const Vec3f &a = tooth_.outer.vertices[i], &b = other.outer.vertices[i];
        ASSERT_EQ(Vec3f(-a.x(), a.y(), a.z()), b);
    }
    EXPECT_GT(test::volumeOf(other.outer), 0);
    EXPECT_NE(other.name.find("left"), std::string::npos);
}

TEST_P(PermanentTooth, IsALayeredTooth) {
    const auto layered = LayeredTooth::make(tooth_.outer, layersOf(tooth_));
    ASSERT_TRUE(layered.has_value()) << layered.error().message();
    EXPECT_EQ(layered->layers().size(), 3u);
    const auto top = std::ranges::max_element(tooth_.outer.vertices, {}, [](const Vec3f& v) { return v.z(); });
    EXPECT_EQ(layered->materialAt(top->cast<double>() - 0.3 * Vec3::UnitZ()), test::kEnamel);
    const auto apex = std::ranges::min_element(tooth_.outer.vertices, {}, [](const Vec3f& v) { return v.z(); });
    EXPECT_EQ(layered->materialAt(apex->cast<double>() + 0.3 * Vec3::UnitZ()), test::kDentin);
}

INSTANTIATE_TEST_SUITE_P(Mouth, PermanentTooth, testing::ValuesIn(kTestedAverages.begin(), kTestedAverages.end()),
                         [](const auto& instance) { return "Fdi" + std::to_string(instance.param.fdi); });

TEST(PermanentTeeth, SeedsGiveOtherPatientsAndTheSameSeedTheSameOne) {
    const BuiltinTooth one = makeTooth({36, kTriangles, 7, {}}), again = makeTooth({36, kTriangles, 7, {}});
    const BuiltinTooth other = makeTooth({36, kTriangles, 8, {}});
    EXPECT_TRUE(test::areBitEqual(one.outer, again.outer));
    EXPECT_TRUE(test::areBitEqual(one.pulp, again.pulp));
    EXPECT_FALSE(test::areBitEqual(one.outer, other.outer));
}

TEST(PermanentTeeth, UpperMolarsHaveThreeRootsAndLowerOnesTwo) {
    const auto roots = [](int fdi, double z) {
        // Components of a section of the roots: connected runs of inner grid points.
        const TriangleMesh& mesh = toothOf(fdi).outer;
        constexpr double kStep = 0.45;
        constexpr int kCount = 32;
        std::array<std::array<int, kCount>, kCount> piece{};
        for (int i = 0; i < kCount; ++i) {
            for (int j = 0; j < kCount; ++j) {
                const Vec3 point((i - kCount / 2) * kStep, (j - kCount / 2) * kStep, z);
                piece[i][j] = test::windingNumber(mesh, point) > 0.5 ? -1 : 0;
            }
        }
        int pieces = 0;
        const std::function<void(int, int)> fill = [&](int i, int j) {
            if (i < 0 || j < 0 || i >= kCount || j >= kCount || piece[i][j] != -1) return;
            piece[i][j] = pieces;
            for (const auto& [di, dj] : {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
                fill(i + di, j + dj);
            }
        };
        for (int i = 0; i < kCount; ++i) {
            for (int j = 0; j < kCount; ++j) {
                if (piece[i][j] != -1) continue;
                ++pieces;
                fill(i, j);
            }
        }
        return pieces;
    };
    EXPECT_EQ(roots(16, -8), 3);
    EXPECT_EQ(roots(46, -8), 2);
    EXPECT_EQ(roots(14, -11), 2);
    EXPECT_EQ(roots(15, -8), 1);
}

TEST(PermanentTeeth, ALesionBeginsWhereItIsAskedForAndIsAsDeep) {
    for (const auto& [site, outward] :
         {std::pair(LesionSite::Mesial, Vec3(1, 0, 0)), std::pair(LesionSite::Distal, Vec3(-1, 0, 0)),
          std::pair(LesionSite::Buccal, Vec3(0, 1, 0)), std::pair(LesionSite::Lingual, Vec3(0, -1, 0))}) {
        const BuiltinTooth tooth = makeTooth({15, kTriangles, 0, Lesion{site, 2.0, 2.0}});
        const Box3 decay = boundingBox(tooth.caries);
        const double deepest = -decay.center().dot(outward) + decay.sizes().dot(outward.cwiseAbs()) / 2;
        const double surface = decay.center().dot(outward) + decay.sizes().dot(outward.cwiseAbs()) / 2;
        EXPECT_GT(surface, 2.0);
        EXPECT_NEAR(surface + deepest, 2.0, 0.35);
    }
}

TEST(PermanentTeeth, NumbersOutsideAMouthAreNone) {
    for (const int fdi : {0, 9, 10, 19, 30, 49, 51, 99, -11}) EXPECT_FALSE(isPermanentTooth(fdi)) << fdi;
    EXPECT_EQ(toothName(26), "Upper left first molar");
    EXPECT_EQ(toothName(41), "Lower right central incisor");
}

}  // namespace
}  // namespace tactooth
