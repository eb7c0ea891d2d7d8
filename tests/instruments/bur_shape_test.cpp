// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/bur_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "instruments/mesh_checks.h"
#include "support/mesh_checks.h"

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
        EXPECT_FALSE(test::intersectsItself(surface));
    }
}

TEST_P(EveryBur, HasItsHeadDiameterWithinTenMicrometres) {
    const TriangleMesh surface = makeBur(spec_).surface;
    EXPECT_NEAR(2 * widestBelow(surface, spec_.headLength + 1e-4), spec_.headDiameter, 0.010);
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

TEST_P(EveryBur, IsTheSameEachTime) { EXPECT_TRUE(test::areBitEqual(makeBur(spec_).surface, makeBur(spec_).surface)); }

std::vector<std::string> allNumbers() {
    std::vector<std::string> numbers;
    for (const BurSpec& spec : burCatalogue()) numbers.push_back(spec.number);
    return numbers;
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryBur, testing::ValuesIn(allNumbers()), [](const auto& instance) {
    std::string name = "No" + instance.param;
    std::ranges::replace(name, '-', '_');
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
    EXPECT_GE(onBall, 6 * spec.flutes);
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

TEST(BurCatalogue, FindsByNumberAndKnowsWhatItLacks) {
    EXPECT_EQ(findBur("4")->headDiameter, 1.4);
    EXPECT_EQ(findBur("57")->kind, BurKind::straightFissure);
    EXPECT_FALSE(findBur("no such bur").has_value());
}

TEST(BurCatalogue, NumbersAreUnique) {
    std::vector<std::string> numbers = allNumbers();
    std::ranges::sort(numbers);
    EXPECT_EQ(std::ranges::adjacent_find(numbers), numbers.end());
}

}  // namespace
}  // namespace tactooth
