// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/surface/cell_qef.h"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <random>
#include <vector>

#include "support/expect_assert.h"

namespace tactooth {
namespace {

const Box3 kCell(Vec3::Constant(-0.5), Vec3::Constant(0.5));

struct Crossing {
    Vec3f point;
    Vec3f normal;
};

/// Cells side by side, each with the planes of its crossings in their order. Other cells have none.
CellQef8 planesOf(const std::array<std::vector<Crossing>, 8>& cells) {
    CellQef8 planes;
    std::size_t most = 0;
    for (const auto& crossings : cells) most = std::max(most, crossings.size());
    for (std::size_t i = 0; i < most; ++i) {
        float normals[3][8] = {}, points[3][8] = {}, counts[8] = {};
        for (std::size_t lane = 0; lane < 8; ++lane) {
            if (i >= cells[lane].size()) continue;
            const Vec3f normal = cells[lane][i].normal.normalized();
            for (int axis = 0; axis < 3; ++axis) {
                normals[axis][lane] = normal[axis];
                points[axis][lane] = cells[lane][i].point[axis];
            }
            counts[lane] = 1;
        }
        planes.add(Vec3x8::load(normals), Vec3x8::load(points), Float8::load(counts));
    }
    return planes;
}
CellQef8 planesOf(const std::vector<Crossing>& crossings) {
    return planesOf(std::array<std::vector<Crossing>, 8>{crossings});
}

Vec3f inLane(const Vec3x8& vectors, int lane) {
    float lanes[3][8];
    vectors.store(lanes);
    return {lanes[0][lane], lanes[1][lane], lanes[2][lane]};
}
std::optional<Vec3f> pointOfFlat(const CellQef8& planes, int lane) {
    const auto [isFlat, points] = planes.flat();
    float flags[8];
    isFlat.store(flags);
    if (flags[lane] == 0) return std::nullopt;
    return inLane(points, lane);
}

/// The reference: one cell and one plane at a time.
std::optional<Vec3f> pointOfFlat(const std::vector<Crossing>& crossings) {
    Vec3f points = Vec3f::Zero(), normals = Vec3f::Zero(), offsets = Vec3f::Zero();
    float xx = 0, xy = 0, xz = 0, yy = 0, yz = 0;
    for (const auto& [point, direction] : crossings) {
        const Vec3f n = direction.normalized();
        points += point;
        normals += n;
        offsets += n * (n.x() * point.x() + n.y() * point.y() + n.z() * point.z());
        xx += n.x() * n.x(), xy += n.x() * n.y(), xz += n.x() * n.z(), yy += n.y() * n.y(), yz += n.y() * n.z();
    }
    const auto count = static_cast<float>(crossings.size());
    const float zz = count - xx - yy;
    const auto timesProducts = [&](const Vec3f& v) {
        return Vec3f(xx * v.x() + xy * v.y() + xz * v.z(), xy * v.x() + yy * v.y() + yz * v.z(),
                     xz * v.x() + yz * v.y() + zz * v.z());
    };
    const float along = normals.dot(timesProducts(normals));
    if (!(count * normals.squaredNorm() - along < 0.03F * along)) return std::nullopt;
    const Vec3f centre = points / count;
    return Vec3f(centre + normals * (5.0F / 6 * normals.dot(Vec3f(offsets - timesProducts(centre))) / along));
}

/// The crossings of a plane through `through` with the four edges along z.
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

TEST(CellQef, OneLevelPlaneHasItsVertexAboveTheMiddle) {
    const CellQef8 planes = planesOf(crossedAlongZ({0, 0, 0.2F}, Vec3f::UnitZ()));
    const auto point = pointOfFlat(planes, 0);
    ASSERT_TRUE(point);
    EXPECT_LT((*point - Vec3f(0, 0, 0.2F)).norm(), 1e-6F);
    EXPECT_LT((inLane(planes.means(), 0) - Vec3f(0, 0, 0.2F)).norm(), 1e-6F);
}

TEST(CellQef, AFlatVertexLiesOnItsPlaneAtEachAngle) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> share(-0.3F, 0.3F);
    for (int i = 0; i < 2000; ++i) {
        const Vec3f normal = Vec3f(share(random), share(random), 1).normalized();
        const Vec3f through(0, 0, 0.5F * share(random));
        const auto point = pointOfFlat(planesOf(crossedAlongZ(through, normal)), 0);
        ASSERT_TRUE(point);
        EXPECT_LT(std::abs(normal.dot(*point - through)), 1e-6F);
    }
}

TEST(CellQef, ABoundaryThatBendsBothWaysHasItsVertexALittleBeyondIt) {
    // A ball with a radius of ten steps.
    const Vec3f middle(0.1F, -0.2F, -10);
    std::vector<Crossing> crossings;
    for (int i = 0; i < 4; ++i) {
        const float x = (i & 1) != 0 ? 0.5F : -0.5F;
        const float y = (i >> 1) != 0 ? 0.5F : -0.5F;
        const float z = middle.z() + std::sqrt(100 - std::pow(x - middle.x(), 2.0F) - std::pow(y - middle.y(), 2.0F));
        crossings.push_back({{x, y, z}, Vec3f(x, y, z) - middle});
    }
    const auto point = pointOfFlat(planesOf(crossings), 0);
    ASSERT_TRUE(point);
    EXPECT_NEAR((*point - middle).norm(), 10, 0.03);
    EXPECT_GT((*point - middle).norm(), 10);  // planes touch a ball from outside
}

TEST(CellQef, ABentBoundaryHasItsVertexTwoThirdsOfTheBendBeyondIt) {
    // A cylinder about y with a radius of ten steps, of which a step bends by 1/80.
    const float radius = 10;
    std::vector<Crossing> crossings;
    for (const float y : {-0.5F, 0.5F}) {
        for (const float x : {-0.5F, 0.5F}) {
            const float z = std::sqrt(radius * radius - x * x);
            crossings.push_back({{x, y, z - radius}, Vec3f(x, 0, z)});
        }
    }
    const auto point = pointOfFlat(planesOf(crossings), 0);
    ASSERT_TRUE(point);
    EXPECT_NEAR(point->z(), 2.0 / 3 / (8 * radius), 2e-5);
    EXPECT_LT(point->head<2>().norm(), 1e-6F);
}

TEST(CellQef, TheVertexOfASharpEdgeLiesOnBothItsPlanes) {
    // x = 0.1 below z = 0.2: a right angle.
    const CellQef8 planes = planesOf({{{0.1F, -0.5F, -0.5F}, Vec3f::UnitX()},
                                      {{0.1F, 0.5F, -0.5F}, Vec3f::UnitX()},
                                      {{-0.5F, -0.5F, 0.2F}, Vec3f::UnitZ()},
                                      {{-0.5F, 0.5F, 0.2F}, Vec3f::UnitZ()}});
    EXPECT_FALSE(pointOfFlat(planes, 0));
    const Vec3f point = planes.nearestPoint(0, kCell);
    EXPECT_NEAR(point.x(), 0.1, 1e-6);
    EXPECT_NEAR(point.y(), 0, 1e-6);
    EXPECT_NEAR(point.z(), 0.2, 1e-6);
}

TEST(CellQef, AVertexAtTheWallOfItsBoxSlidesAlongTheEdge) {
    // The planes z = y - 0.3 and z = 0.9 - y meet at y = 0.6, outside the cell. Held at 0.5, the vertex is equally near
    // to both.
    const Vec3f up = Vec3f(0, -1, 1).normalized();
    const Vec3f down = Vec3f(0, 1, 1).normalized();
    const CellQef8 planes = planesOf({{{-0.5F, -0.1F, -0.4F}, up},
                                      {{0.5F, -0.1F, -0.4F}, up},
                                      {{-0.5F, 0.8F, 0.1F}, down},
                                      {{0.5F, 0.8F, 0.1F}, down}});
    const Vec3f point = planes.nearestPoint(0, kCell);
    EXPECT_NEAR(point.y(), 0.5, 1e-6);
    EXPECT_NEAR(point.z(), 0.3, 1e-6);
    EXPECT_NEAR(planes.nearestPoint(0, Box3(Vec3::Constant(-1), Vec3::Constant(1))).y(), 0.6, 1e-5);
}

TEST(CellQef, ACornerOfThreePlanesIsFound) {
    const CellQef8 planes = planesOf({{{0.1F, -0.5F, -0.5F}, Vec3f::UnitX()},
                                      {{-0.5F, -0.2F, -0.5F}, Vec3f::UnitY()},
                                      {{-0.5F, -0.5F, 0.3F}, Vec3f::UnitZ()}});
    EXPECT_FALSE(pointOfFlat(planes, 0));
    EXPECT_LT((planes.nearestPoint(0, kCell) - Vec3f(0.1F, -0.2F, 0.3F)).norm(), 1e-6F);
}

TEST(CellQef, EightCellsGetTheBitsOfEachByItself) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> share(-0.5F, 0.5F);
    std::array<int, 2> seen{};  // sharp, flat
    for (int i = 0; i < 500; ++i) {
        std::array<std::vector<Crossing>, 8> cells;
        for (auto& crossings : cells) {
            const float bend = random() % 2 == 0 ? 0.1F : 1;
            const Vec3f normal(share(random), share(random), share(random));
            for (std::size_t left = 3 + random() % 5; left > 0; --left) {
                const Vec3f turn(share(random), share(random), share(random));
                crossings.push_back({{share(random), share(random), share(random)}, normal + bend * turn});
            }
        }
        const CellQef8 planes = planesOf(cells);
        for (int lane = 0; lane < 8; ++lane) {
            const auto point = pointOfFlat(planes, lane);
            ASSERT_EQ(point, pointOfFlat(cells[static_cast<std::size_t>(lane)]));
            ++seen[point ? 1 : 0];
            const CellQef8 alone = planesOf(cells[static_cast<std::size_t>(lane)]);
            ASSERT_EQ(planes.nearestPoint(lane, kCell), alone.nearestPoint(0, kCell));
        }
    }
    for (const int count : seen) EXPECT_GT(count, 200);
}

TEST(CellQefAsserts, ALaneIsOneOfEightAndARoomHoldsAPoint) {
    const CellQef8 planes = planesOf(crossedAlongZ({0, 0, 0.2F}, Vec3f::UnitZ()));
    EXPECT_ASSERT(static_cast<void>(planes.nearestPoint(8, kCell)));
    EXPECT_ASSERT(static_cast<void>(planes.nearestPoint(0, Box3())));
}

}  // namespace
}  // namespace tactooth
