// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/bur_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "instruments/bur_outline.h"
#include "instruments/mesh_checks.h"
#include "support/mesh_checks.h"
#include "tooth/sweep/revolution_envelope.h"

namespace tactooth {
namespace {

double radiusOf(const Vec3f& vertex) { return std::hypot(vertex.x(), vertex.y()); }

/// Largest radius of the vertices up to the height `z`.
double widestBelow(const TriangleMesh& mesh, double z) {
    double widest = 0;
    for (const Vec3f& vertex : mesh.vertices) {
        if (vertex.z() <= z) widest = std::max(widest, radiusOf(vertex));
    }
    return widest;
}

class EveryBur : public testing::TestWithParam<std::string> {
protected:
    BurSpec spec_ = findBur(GetParam()).value();
};

TEST_P(EveryBur, IsClosedOrientedAndDoesNotIntersectItself) {
    for (const int triangles : {kContactBurTriangles, 1200, 5000}) {
        const TriangleMesh surface = makeBur(spec_, triangles).surface;
        EXPECT_EQ(test::unpairedEdges(surface), 0);
        EXPECT_GT(test::volumeOf(surface), 0);
        EXPECT_FALSE(test::selfIntersects(surface));
    }
}

TEST_P(EveryBur, HasItsHeadDiameterWithinTenMicrometres) {
    const TriangleMesh surface = makeBur(spec_).surface;
    EXPECT_NEAR(2 * widestBelow(surface, spec_.headLength + 1e-4), spec_.headDiameter, 0.010);
}

/// Radius of an outline at a height between its ends; the outline begins on the axis.
double radiusAt(const std::vector<OutlinePoint>& outline, double z) {
    OutlinePoint before{0, 0};
    for (const OutlinePoint& point : outline) {
        if (z <= point.z && point.z > before.z) {
            return std::lerp(before.radius, point.radius, (z - before.z) / (point.z - before.z));
        }
        before = point;
    }
    return before.radius;
}

TEST_P(EveryBur, ItsHeadEndsWhereTheCatalogueSays) {
    EXPECT_NEAR(burOutline(spec_, 12).back().z, spec_.headLength, 1e-9);
    const TriangleMesh surface = makeBur(spec_, 5000).surface;
    const bool hasEnd = std::ranges::any_of(
        surface.vertices, [&](const Vec3f& v) { return std::abs(v.z() - spec_.headLength) < 1e-5 && radiusOf(v) > 0; });
    EXPECT_TRUE(hasEnd);
}

TEST_P(EveryBur, SweepsItsOutlineWithinTwoMicrometres) {
    // Sampled where the mesh has its rings; between them the mesh is as straight as the outline through the rings.
    for (const int triangles : {kContactBurTriangles, 5000, 20000}) {
        const Bur bur = makeBur(spec_, triangles);
        std::vector<OutlinePoint> swept;
        for (const auto& [radius, z] : revolutionProfile(bur.surface)) swept.push_back({radius, z});
        const std::vector<OutlinePoint> fine = burOutline(spec_, 4000);
        for (std::size_t i = 0; i < bur.surface.vertices.size(); i += 7) {
            const double z = bur.surface.vertices[i].z();
            if (z < 0.01 || z > spec_.headLength - 1e-3) continue;  // a pole has no slope to compare by
            ASSERT_NEAR(radiusAt(swept, z), radiusAt(fine, z), 0.002) << "at " << z << " of " << triangles;
        }
    }
}

TEST_P(EveryBur, NeverStandsOutOfItsOutline) {
    const std::vector<OutlinePoint> fine = burOutline(spec_, 4000);
    for (const Vec3f& vertex : makeBur(spec_, 20000).surface.vertices) {
        if (vertex.z() < 1e-3 || vertex.z() > spec_.headLength - 1e-3) continue;
        ASSERT_LE(radiusOf(vertex), radiusAt(fine, vertex.z()) + 1e-4);
    }
}

TEST_P(EveryBur, IsFoundByItsIsoNumber) {
    const auto found = findBur(isoNumber(spec_));
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->number, spec_.number);
}

TEST_P(EveryBur, StandsOnItsTipAndEndsInAFrictionGripShank) {
    const TriangleMesh surface = makeBur(spec_).surface;
    const Box3 box = boundingBox(surface);
    EXPECT_EQ(box.min().z(), 0);
    EXPECT_GT(box.max().z(), spec_.headLength + 2);
    double shank = 0;
    for (const Vec3f& vertex : surface.vertices) {
        if (vertex.z() == static_cast<float>(box.max().z())) shank = std::max(shank, radiusOf(vertex));
    }
    EXPECT_NEAR(2 * shank, kShankDiameter, 1e-5);
}

TEST_P(EveryBur, HasAFewHundredTrianglesByDefault) {
    const std::size_t triangles = makeBur(spec_).surface.triangles.size();
    EXPECT_GE(triangles, 300u);
    EXPECT_LE(triangles, 400u);
}

TEST_P(EveryBur, HasAsManyTrianglesAsAreAskedForOrOneFewerOfAnOddNumber) {
    for (const int triangles : {333, 334, 1999, 20988}) {
        const TriangleMesh surface = makeBurWithTriangles(spec_, triangles).surface;
        EXPECT_EQ(surface.triangles.size(), static_cast<std::size_t>(triangles / 2 * 2));
        EXPECT_EQ(test::unpairedEdges(surface), 0);
        EXPECT_NEAR(test::volumeOf(surface), test::volumeOf(makeBur(spec_, triangles).surface), 1e-5);
        if (triangles < 1000) {
            EXPECT_FALSE(test::selfIntersects(surface));
        }
    }
}

TEST_P(EveryBur, IsTheSameEachTime) { EXPECT_TRUE(test::areBitEqual(makeBur(spec_).surface, makeBur(spec_).surface)); }

std::vector<std::string> allNumbers() {
    std::vector<std::string> numbers;
    for (const BurSpec& spec : burCatalogue()) numbers.push_back(spec.number);
    return numbers;
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryBur, testing::ValuesIn(allNumbers()), [](const auto& instance) {
    std::string name = "No" + instance.param;
    std::ranges::replace(name, '-', '_');
    std::ranges::replace(name, '/', '_');
    return name;
});

TEST(BurShape, RoundBurLiesOnItsBallAndTouchesItAtTheBladeEdges) {
    const BurSpec spec = findBur("4").value();
    const Vec3 centre(0, 0, spec.headDiameter / 2);
    int onBall = 0;
    for (const Vec3f& vertex : makeBur(spec).surface.vertices) {
        if (vertex.z() > 1.0f) continue;
        const double distance = (vertex.cast<double>() - centre).norm() - spec.headDiameter / 2;
        EXPECT_LE(distance, 1e-6);
        if (distance > -1e-6) ++onBall;
    }
    EXPECT_GE(onBall, 6 * spec.contactFlutes);
}

/// Blade edges at the equator of a ball, in a picture: vertices on it, with a gullet on both sides.
int bladesShown(const BurSpec& spec) {
    const TriangleMesh surface = makeBur(spec, 20000).surface;
    const double radius = spec.headDiameter / 2;
    const auto apart = [&](const Vec3f& v) { return std::abs(v.z() - radius); };
    const auto nearest = std::ranges::min_element(surface.vertices, {}, apart);
    std::vector<std::pair<double, double>> ring;  // angle, radius
    double widest = 0;
    for (const Vec3f& v : surface.vertices) {
        if (v.z() != nearest->z()) continue;
        ring.emplace_back(std::atan2(v.y(), v.x()), radiusOf(v));
        widest = std::max(widest, radiusOf(v));
    }
    std::ranges::sort(ring);
    return static_cast<int>(std::ranges::count_if(ring, [&](const auto& at) { return at.second > widest - 1e-5; }));
}

TEST(BurShape, RoundCarbidesShowEightBlades) {
    for (const std::string number : {"1/4", "1/2", "1", "2", "3", "4", "5", "6", "7", "8"}) {
        const BurSpec spec = findBur(number).value();
        EXPECT_EQ(spec.flutes, 8) << number;
        EXPECT_EQ(bladesShown(spec), 8) << number;
    }
    EXPECT_EQ(bladesShown(findBur("7006").value()), 12);
}

TEST(BurShape, FissureBurIsACylinderWithAFlatEnd) {
    const BurSpec spec = findBur("57").value();
    const TriangleMesh surface = makeBur(spec).surface;
    EXPECT_NEAR(widestBelow(surface, 0), spec.headDiameter / 2, 1e-6);
    EXPECT_NEAR(widestBelow(surface, spec.headLength), spec.headDiameter / 2, 1e-6);
}

TEST(BurShape, PearNarrowsTowardItsShank) {
    const BurSpec spec = findBur("330").value();
    const TriangleMesh surface = makeBur(spec).surface;
    double endRadius = 0;
    for (const Vec3f& vertex : surface.vertices) {
        if (std::abs(vertex.z() - spec.headLength) < 1e-5) endRadius = std::max(endRadius, radiusOf(vertex));
    }
    EXPECT_LT(endRadius, 0.45 * spec.headDiameter);
    EXPECT_GT(endRadius, 0.30 * spec.headDiameter);
}

/// Smallest part of the full radius that a vertex of the ball's equator has.
double deepestGullet(const BurSpec& spec) {
    double deepest = 1;
    for (const Vec3f& vertex : makeBur(spec).surface.vertices) {
        if (std::abs(vertex.z() - spec.headDiameter / 2) > 1e-5) continue;
        deepest = std::min(deepest, radiusOf(vertex) / (spec.headDiameter / 2));
    }
    return deepest;
}

TEST(BurShape, CarbideHasGulletsAndDiamondIsRound) {
    EXPECT_LT(deepestGullet(findBur("4").value()), 0.8);
    EXPECT_NEAR(deepestGullet(findBur("801-014").value()), 1, 1e-6);
}

int verticesBelowTheOutline(const BurSpec& spec, int triangles) {
    const std::vector<OutlinePoint> fine = burOutline(spec, 4000);
    int below = 0;
    for (const Vec3f& v : makeBur(spec, triangles).surface.vertices) {
        const bool onSide = v.z() > 0.5 && v.z() < 0.7 * spec.headLength;
        if (onSide && radiusOf(v) < radiusAt(fine, v.z()) - 0.005) ++below;
    }
    return below;
}

TEST(BurShape, FineDiamondsShowTheirGrains) {
    const BurSpec spec = findBur("856-016").value();
    EXPECT_GT(verticesBelowTheOutline(spec, 20000), 1000);
    EXPECT_EQ(verticesBelowTheOutline(spec, kContactBurTriangles), 0);
}

TEST(BurShape, CrossCutBladesHaveNotches) {
    const int plain = verticesBelowTheOutline(findBur("57").value(), 20000);
    EXPECT_GT(verticesBelowTheOutline(findBur("557").value(), 20000), plain + 100);
}

TEST(BurShape, TapersHaveTheirAngle) {
    const std::vector<OutlinePoint> outline = burOutline(findBur("700").value(), 20);
    const double widening = outline.back().radius - outline.front().radius;
    EXPECT_NEAR(std::atan2(widening, outline.back().z), 3 * std::numbers::pi / 180, 1e-9);
}

TEST(BurCatalogue, IsoNumbersAreThoseOnTheBox) {
    EXPECT_EQ(isoNumber(*findBur("4")), "500 314 001 001 014");
    EXPECT_EQ(isoNumber(*findBur("801-014")), "806 314 001 524 014");
    EXPECT_EQ(findBur("806314001524014")->number, "801-014");
}

TEST(BurCatalogue, ADiamondComesInEveryGrit) {
    EXPECT_EQ(findBur("806 314 198 504 016")->gritMicrometres, 30);
    EXPECT_EQ(findBur("806 314 198 544 016")->gritMicrometres, 180);
    EXPECT_FALSE(findBur("806 314 198 999 016").has_value());
    EXPECT_FALSE(findBur("806 314 198 524 0165").has_value());
}

TEST(BurCatalogue, FindsByNumberAndKnowsWhatItLacks) {
    EXPECT_EQ(findBur("4")->headDiameter, 1.4);
    EXPECT_EQ(findBur("57")->kind, BurKind::StraightFissure);
    EXPECT_FALSE(findBur("no such bur").has_value());
}

TEST(BurCatalogue, NumbersAreUnique) {
    std::vector<std::string> numbers = allNumbers();
    std::ranges::sort(numbers);
    EXPECT_EQ(std::ranges::adjacent_find(numbers), numbers.end());
}

}  // namespace
}  // namespace tactooth
