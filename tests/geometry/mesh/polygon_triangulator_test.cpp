// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/polygon_triangulator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <string>

#include "geometry/mesh/vertex_welder.h"
#include "geometry/outlines.h"

namespace tactooth {
namespace {

using namespace test;

double areaOf(const Outline& outline) {
    double area = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
        area += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
    return area;
}

/// A face of a file: welded positions and corners.
struct Face {
    std::vector<Vec3f> positions;
    std::vector<std::uint32_t> corners;
};

Face faceOf(const Outline& outline, const Quat& turn, const Vec3& place, std::size_t first, double bumps = 0,
            Random* random = nullptr) {
    VertexWelder welder(outline.size());
    std::map<std::pair<double, double>, Vec3f> placed;
    Face face;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2& at = outline[(i + first) % outline.size()];
        const double height = random == nullptr ? 0 : uniform(*random, -bumps, bumps);
        const Vec3f position = (turn * Vec3(at.x(), at.y(), height) + place).cast<float>();
        face.corners.push_back(welder.add(placed.try_emplace({at.x(), at.y()}, position).first->second));
    }
    face.positions = welder.takeVertices();
    return face;
}

double areaOf(const Face& face, const std::vector<Triangle>& triangles) {
    double area = 0;
    for (const Triangle& t : triangles) {
        const Vec3 a = face.positions[t[0]].cast<double>();
        area += 0.5 * (face.positions[t[1]].cast<double>() - a).cross(face.positions[t[2]].cast<double>() - a).norm();
    }
    return area;
}

/// The directed edges that no other triangle cancels are those of the outline.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> borderOf(const std::vector<Triangle>& triangles) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> border;
    for (const Triangle& t : triangles) {
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t a = t[i], b = t[(i + 1) % 3];
            a < b ? ++border[{a, b}] : --border[{b, a}];
        }
    }
    std::erase_if(border, [](const auto& edge) { return edge.second == 0; });
    return border;
}

std::map<std::pair<std::uint32_t, std::uint32_t>, int> borderOf(const Face& face) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> border;
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
        const std::uint32_t a = face.corners[i], b = face.corners[(i + 1) % face.corners.size()];
        if (a != b) a < b ? ++border[{a, b}] : --border[{b, a}];
    }
    std::erase_if(border, [](const auto& edge) { return edge.second == 0; });
    return border;
}

Quat anyRotation(Random& random) {
    return Quat(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1))
        .normalized();
}

class AnyOutline : public ::testing::TestWithParam<Shape> {};
INSTANTIATE_TEST_SUITE_P(PolygonTriangulator, AnyOutline, ::testing::ValuesIn(kShapes), [](const auto& outline) {
    std::string name = outline.param.name;
    std::erase(name, ' ');
    return name;
});

TEST_P(AnyOutline, IsCoveredOnceWhateverItsPlaneAndFirstCorner) {
    Random random(20261125);
    PolygonTriangulator splitter;
    for (int round = 0; round < 300; ++round) {
        const Outline outline = GetParam().make(random);
        const std::size_t first = random() % outline.size();
        const Face face =
            faceOf(outline, anyRotation(random), Vec3(uniform(random, -20, 20), 7, uniform(random, -20, 20)), first);
        std::vector<Triangle> triangles;
        const MessageText* const problem = splitter.split(face.positions, face.corners, triangles);
        ASSERT_EQ(problem, nullptr) << round;
        EXPECT_NEAR(areaOf(face, triangles), areaOf(outline), 1e-4) << round;
        EXPECT_EQ(borderOf(triangles), borderOf(face)) << round;
    }
}

TEST_P(AnyOutline, NeedNotBeQuitePlane) {
    Random random(7);
    PolygonTriangulator splitter;
    for (int round = 0; round < 100; ++round) {
        const Outline outline = GetParam().make(random);
        const Face face = faceOf(outline, anyRotation(random), Vec3::Zero(), random() % outline.size(), 1e-3, &random);
        std::vector<Triangle> triangles;
        ASSERT_EQ(splitter.split(face.positions, face.corners, triangles), nullptr) << round;
        EXPECT_NEAR(areaOf(face, triangles), areaOf(outline), 0.02 * areaOf(outline)) << round;
        EXPECT_EQ(borderOf(triangles), borderOf(face)) << round;
    }
}

TEST_P(AnyOutline, MakesNoFlatTriangleInItsOwnPlane) {
    Random random(8);
    PolygonTriangulator splitter;
    for (int round = 0; round < 100; ++round) {
        Outline outline = GetParam().make(random);
        for (Vec2& corner : outline) corner = (corner * 4096).array().round().matrix() / 4096;  // exact
        const Face face = faceOf(outline, Quat::Identity(), Vec3::Zero(), random() % outline.size());
        std::vector<Triangle> triangles;
        ASSERT_EQ(splitter.split(face.positions, face.corners, triangles), nullptr) << round;
        for (const Triangle& triangle : triangles) EXPECT_GT(areaOf(face, {triangle}), 0) << round;
    }
}

TEST_P(AnyOutline, ScaleDoesNotMatter) {
    for (const double scale : {1e-6, 1e-3, 1e3, 1e6}) {
        Random random(9);
        PolygonTriangulator splitter;
        for (int round = 0; round < 30; ++round) {
            Outline outline = GetParam().make(random);
            for (Vec2& corner : outline) corner *= scale;
            const Face face = faceOf(outline, anyRotation(random), Vec3::Zero(), random() % outline.size());
            std::vector<Triangle> triangles;
            ASSERT_EQ(splitter.split(face.positions, face.corners, triangles), nullptr) << round;
            EXPECT_NEAR(areaOf(face, triangles), areaOf(outline), 1e-4 * areaOf(outline)) << round;
        }
    }
}

std::vector<Triangle> splitPlain(const Outline& outline) {
    const Face face = faceOf(outline, Quat::Identity(), Vec3::Zero(), 0);
    std::vector<Triangle> triangles;
    PolygonTriangulator splitter;
    EXPECT_EQ(splitter.split(face.positions, face.corners, triangles), nullptr);
    return triangles;
}

const MessageText* problemOf(const Outline& outline) {
    const Face face = faceOf(outline, Quat::Identity(), Vec3::Zero(), 0);
    std::vector<Triangle> triangles;
    PolygonTriangulator splitter;
    const MessageText* const problem = splitter.split(face.positions, face.corners, triangles);
    EXPECT_EQ(problem == nullptr, !triangles.empty());
    return problem;
}

TEST(PolygonTriangulator, AConvexFaceGetsTheFanFromItsFirstCorner) {
    for (const int corners : {4, 5, 8, 100}) {
        Outline outline;
        for (int i = 0; i < corners; ++i) {
            const double angle = 2 * std::numbers::pi * i / corners;
            outline.emplace_back(std::cos(angle), std::sin(angle));
        }
        std::vector<Triangle> fan;
        for (std::uint32_t i = 2; i < static_cast<std::uint32_t>(corners); ++i) fan.push_back({0, i - 1, i});
        EXPECT_EQ(splitPlain(outline), fan) << corners;
    }
}

TEST(PolygonTriangulator, AnArrowHeadIsSplitByTheDiagonalThatLiesInIt) {
    const Outline arrow = {{0, 0}, {2, -2}, {1, 0}, {2, 2}};
    for (int first = 0; first < 4; ++first) {
        Outline turned = arrow;
        std::rotate(turned.begin(), turned.begin() + first, turned.end());
        double area = 0;
        const Face face = faceOf(turned, Quat::Identity(), Vec3::Zero(), 0);
        for (const Triangle& triangle : splitPlain(turned)) area += areaOf(face, {triangle});
        EXPECT_DOUBLE_EQ(area, 2) << first;
    }
}

TEST(PolygonTriangulator, CornersThatRoundingPutBesideALineMakeNoFlatTriangle) {
    // Tenths, which are not exact in a float: the last three are on one line in the text, and not after rounding.
    for (const Outline& tenths : {Outline{{2, 4}, {1, 4}, {1, 3}, {2, 2}, {4, 2}, {3, 3}},
                                  Outline{{3, 7}, {0, 8}, {2, 1}, {6, 0}, {7, 3}, {4, 6}},
                                  Outline{{0, 4}, {2, 2}, {3, 1}, {1, 2}, {2, 1}, {5, 0}}}) {
        for (std::size_t first = 0; first < tenths.size(); ++first) {
            Outline outline = tenths;
            std::ranges::rotate(outline, outline.begin() + static_cast<std::ptrdiff_t>(first));
            for (Vec2& corner : outline) corner *= 0.1;
            const Face face = faceOf(outline, Quat::Identity(), Vec3::Zero(), 0);
            for (const Triangle& triangle : splitPlain(outline)) EXPECT_GT(areaOf(face, {triangle}), 1e-4) << first;
        }
    }
}

TEST(PolygonTriangulator, ASpikeFallsAway) {
    EXPECT_EQ(splitPlain({{0, 0}, {4, 0}, {7, 0}, {4, 0}, {4, 4}, {0, 4}}).size(), 2u);
    EXPECT_EQ(splitPlain({{7, 7}, {4, 4}, {0, 4}, {0, 0}, {4, 0}, {4, 4}}).size(), 2u);
}

TEST(PolygonTriangulator, AFaceWithoutAreaStaysForTheReport) {
    EXPECT_EQ(splitPlain({{0, 0}, {1, 0}, {2, 0}, {3, 0}}).size(), 2u);
    EXPECT_EQ(splitPlain({{1, 1}, {1, 1}, {1, 1}, {1, 1}}).size(), 2u);
}

TEST(PolygonTriangulator, RefusesOutlinesThatCrossThemselves) {
    EXPECT_NE(problemOf({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), nullptr);           // bow tie
    EXPECT_NE(problemOf({{0, 0}, {4, 1}, {4, 0}, {0, 3}}), nullptr);           // of two sizes
    EXPECT_NE(problemOf({{0, 0}, {2, 3}, {4, 0}, {0, 2}, {4, 2}}), nullptr);   // pentagram
    EXPECT_NE(problemOf({{0, 0}, {6, 0}, {6, 4}, {3, -2}, {0, 4}}), nullptr);  // a corner through an edge
    EXPECT_NE(problemOf({{0, 0}, {2, 2}, {2, 0}, {0, 2}, {-1, 1}}), nullptr);
}

TEST(PolygonTriangulator, FiftyThousandCornersTakeLessThanSeconds) {
    Outline outline;
    constexpr int kTeeth = 12'500;
    for (int i = 0; i < 2 * kTeeth; ++i) outline.emplace_back(i, i % 2 == 0 ? 0 : 1);
    for (int i = 2 * kTeeth; i-- > 0;) outline.emplace_back(i, i % 2 == 0 ? 10 : 11);
    EXPECT_EQ(splitPlain(outline).size(), outline.size() - 2);
}

}  // namespace
}  // namespace tactooth
