// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/cell_planes.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

namespace tactooth {
namespace {

const Box3 kCell(Vec3::Constant(-0.5), Vec3::Constant(0.5));

struct Crossing {
    Vec3f point;
    Vec3f normal;
};

CellPlanes planesOf(const std::vector<Crossing>& crossings) {
    CellPlanes planes;
    for (const auto& [point, normal] : crossings) {
        planes.add(CellPlanes::Plane(normal.normalized()), Eigen::Array4f(point.x(), point.y(), point.z(), 1));
    }
    return planes;
}

/// Where a plane through `through` crosses the four edges along z.
std::vector<Crossing> crossedAlongZ(const Vec3f& through, const Vec3f& normal) {
    std::vector<Crossing> crossings;
    for (int i = 0; i < 4; ++i) {
        const float x = (i & 1) != 0 ? 0.5F : -0.5F;
        const float y = (i >> 1) != 0 ? 0.5F : -0.5F;
        const float z = through.z() - (normal.x() * (x - through.x()) + normal.y() * (y - through.y())) / normal.z();
        crossings.push_back({{x, y, z}, normal});
    }
    return crossings;
}

TEST(CellPlanes, OneLevelPlaneHasItsVertexAboveTheMiddle) {
    const CellPlanes planes = planesOf(crossedAlongZ({0, 0, 0.2F}, Vec3f::UnitZ()));
    const auto point = planes.pointOfFlat();
    ASSERT_TRUE(point);
    EXPECT_LT((*point - Vec3f(0, 0, 0.2F)).norm(), 1e-6F);
    EXPECT_LT((planes.mean() - Vec3f(0, 0, 0.2F)).norm(), 1e-6F);
}

TEST(CellPlanes, AFlatVertexLiesOnItsPlaneWhichWayEverItLeans) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> share(-0.3F, 0.3F);
    for (int i = 0; i < 2000; ++i) {
        const Vec3f normal = Vec3f(share(random), share(random), 1).normalized();
        const Vec3f through(0, 0, 0.5F * share(random));
        const auto point = planesOf(crossedAlongZ(through, normal)).pointOfFlat();
        ASSERT_TRUE(point);
        EXPECT_LT(std::abs(normal.dot(*point - through)), 1e-6F);
    }
}

TEST(CellPlanes, AFlatBorderThatBendsALittleHasItsVertexWhereThePlanesAgreeBest) {
    // A ball of ten steps: the vertex lies on it, to what its planes leave open.
    const Vec3f middle(0.1F, -0.2F, -10);
    std::vector<Crossing> crossings;
    for (int i = 0; i < 4; ++i) {
        const float x = (i & 1) != 0 ? 0.5F : -0.5F;
        const float y = (i >> 1) != 0 ? 0.5F : -0.5F;
        const float z = middle.z() + std::sqrt(100 - std::pow(x - middle.x(), 2.0F) - std::pow(y - middle.y(), 2.0F));
        crossings.push_back({{x, y, z}, Vec3f(x, y, z) - middle});
    }
    const auto point = planesOf(crossings).pointOfFlat();
    ASSERT_TRUE(point);
    EXPECT_NEAR((*point - middle).norm(), 10, 0.03);
    EXPECT_GT((*point - middle).norm(), 10);  // planes touch a ball from outside
}

TEST(CellPlanes, TheVertexOfASharpEdgeLiesOnBothItsPlanes) {
    // x = 0.1 below z = 0.2: a right angle.
    const CellPlanes planes = planesOf({{{0.1F, -0.5F, -0.5F}, Vec3f::UnitX()},
                                        {{0.1F, 0.5F, -0.5F}, Vec3f::UnitX()},
                                        {{-0.5F, -0.5F, 0.2F}, Vec3f::UnitZ()},
                                        {{-0.5F, 0.5F, 0.2F}, Vec3f::UnitZ()}});
    EXPECT_FALSE(planes.pointOfFlat());
    const Vec3f point = planes.nearestPoint(kCell);
    EXPECT_NEAR(point.x(), 0.1, 1e-6);
    EXPECT_NEAR(point.y(), 0, 1e-6);
    EXPECT_NEAR(point.z(), 0.2, 1e-6);
}

TEST(CellPlanes, AVertexThatItsRoomHoldsBackSlidesAlongTheEdge) {
    // The planes z = y - 0.3 and z = 0.9 - y meet at y = 0.6, outside: held at 0.5, it is as near to both.
    const Vec3f up = Vec3f(0, -1, 1).normalized();
    const Vec3f down = Vec3f(0, 1, 1).normalized();
    const CellPlanes planes = planesOf({{{-0.5F, -0.1F, -0.4F}, up},
                                        {{0.5F, -0.1F, -0.4F}, up},
                                        {{-0.5F, 0.8F, 0.1F}, down},
                                        {{0.5F, 0.8F, 0.1F}, down}});
    const Vec3f point = planes.nearestPoint(kCell);
    EXPECT_NEAR(point.y(), 0.5, 1e-6);
    EXPECT_NEAR(point.z(), 0.3, 1e-6);
    EXPECT_NEAR(planes.nearestPoint(Box3(Vec3::Constant(-1), Vec3::Constant(1))).y(), 0.6, 1e-5);
}

TEST(CellPlanes, ACornerOfThreePlanesIsFound) {
    const CellPlanes planes = planesOf({{{0.1F, -0.5F, -0.5F}, Vec3f::UnitX()},
                                        {{-0.5F, -0.2F, -0.5F}, Vec3f::UnitY()},
                                        {{-0.5F, -0.5F, 0.3F}, Vec3f::UnitZ()}});
    EXPECT_FALSE(planes.pointOfFlat());
    EXPECT_LT((planes.nearestPoint(kCell) - Vec3f(0.1F, -0.2F, 0.3F)).norm(), 1e-6F);
}

TEST(CellPlanes, EqualPlanesInEqualOrderGiveEqualBits) {
    const auto crossings = crossedAlongZ({0.3F, 0.1F, 0.123F}, Vec3f(0.2F, 0.1F, 0.9F));
    const Vec3f one = *planesOf(crossings).pointOfFlat();
    const Vec3f two = *planesOf(crossings).pointOfFlat();
    EXPECT_EQ(std::memcmp(one.data(), two.data(), sizeof(Vec3f)), 0);
}

}  // namespace
}  // namespace tactooth
