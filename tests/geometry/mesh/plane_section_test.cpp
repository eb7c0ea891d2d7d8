// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/plane_section.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/shapes.h"

namespace tactooth {
namespace {

const Eigen::AlignedBox2d kBox(Vec2(-1, -1), Vec2(1, 1));

double areaOf(const std::vector<Vec2>& line) {
    double sum = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Vec2 &a = line[i], &b = line[(i + 1) % line.size()];
        sum += a.x() * b.y() - a.y() * b.x();
    }
    return std::abs(sum) / 2;
}

double lengthOf(const std::vector<SectionLine>& lines) {
    double length = 0;
    for (const SectionLine& line : lines) {
        for (std::size_t i = 0; i + (line.closed ? 0 : 1) < line.points.size(); ++i) {
            length += (line.points[(i + 1) % line.points.size()] - line.points[i]).norm();
        }
    }
    return length;
}

TEST(PlaneSection, OfABoxIsARectangle) {
    const TriangleMesh mesh = test::box(Vec3(-1, -2, -3), Vec3(1, 2, 3));
    const auto lines = planeSection(mesh, {Vec3(0, 0, 0.5), Vec3::UnitX(), Vec3::UnitY()});
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_TRUE(lines[0].closed);
    EXPECT_NEAR(areaOf(lines[0].points), 8, 1e-9);
    EXPECT_NEAR(lengthOf(lines), 12, 1e-9);
    EXPECT_TRUE(planeSection(mesh, {Vec3(0, 0, 4), Vec3::UnitX(), Vec3::UnitY()}).empty());
}

TEST(PlaneSection, OfASlantedPlaneHasTheClosedForm) {
    const TriangleMesh mesh = test::box(Vec3(-1, -1, -5), Vec3(1, 1, 5));
    for (const double angle : {0.2, 0.6, 1.0}) {
        const SectionPlane plane{Vec3(0.1, 0.2, 0.3), Vec3(std::cos(angle), 0, std::sin(angle)), Vec3::UnitY()};
        const auto lines = planeSection(mesh, plane);
        ASSERT_EQ(lines.size(), 1U);
        EXPECT_NEAR(areaOf(lines[0].points), 4 / std::cos(angle), 1e-6);
    }
}

TEST(PlaneSection, TwoBodiesGiveTwoLines) {
    TriangleMesh mesh = test::box(Vec3(-3, -1, -1), Vec3(-1, 1, 1));
    append(mesh, test::box(Vec3(1, -1, -1), Vec3(2, 1, 1)));
    const auto lines = planeSection(mesh, {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitZ()});
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_NEAR(areaOf(lines[0].points) + areaOf(lines[1].points), 4 + 2, 1e-9);
}

TEST(PlaneSection, AnOpenMeshGivesAnOpenLine) {
    TriangleMesh mesh = test::box(Vec3(-1, -1, -1), Vec3(1, 1, 1));
    std::erase_if(mesh.triangles, [&](const Triangle& t) {  // without the side at x = 1
        return mesh.vertices[t[0]].x() > 0 && mesh.vertices[t[1]].x() > 0 && mesh.vertices[t[2]].x() > 0;
    });
    const auto lines = planeSection(mesh, {Vec3(0, 0, 0.25), Vec3::UnitX(), Vec3::UnitY()});
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_FALSE(lines[0].closed);
    EXPECT_NEAR(lengthOf(lines), 6, 1e-9);
}

TEST(PlaneSection, ACornerInThePlaneLeavesTheLineClosed) {
    const TriangleMesh mesh = test::box(Vec3(-1, -1, -1), Vec3(1, 1, 1));
    for (const double z : {-1.0, 1.0}) {
        for (const SectionLine& line : planeSection(mesh, {Vec3(0, 0, z), Vec3::UnitX(), Vec3::UnitY()})) {
            EXPECT_TRUE(line.closed);
        }
    }
    const SectionPlane diagonal{Vec3::Zero(), Vec3(1, 1, 0).normalized(), Vec3::UnitZ()};  // through four corners
    for (const SectionLine& line : planeSection(mesh, diagonal)) {
        EXPECT_TRUE(line.closed);
        EXPECT_NEAR(areaOf(line.points), 4 * std::numbers::sqrt2, 1e-6);
    }
}

TEST(PlaneSection, ClipsAClosedLineToTheRectangle) {
    const std::vector<Vec2> large = {{-3, -3}, {3, -3}, {3, 3}, {-3, 3}};
    EXPECT_NEAR(areaOf(clipped(large, kBox)), 4, 1e-12);
    const std::vector<Vec2> half = {{0, -3}, {3, -3}, {3, 3}, {0, 3}};
    EXPECT_NEAR(areaOf(clipped(half, kBox)), 2, 1e-12);
    EXPECT_TRUE(clipped({{2, 2}, {3, 2}, {3, 3}}, kBox).empty());
    const std::vector<Vec2> small = {{0, 0}, {0.5, 0}, {0, 0.5}};
    EXPECT_NEAR(areaOf(clipped(small, kBox)), 0.125, 1e-12);
}

TEST(PlaneSection, DrawsOnlyThePiecesWithinTheRectangle) {
    // A square of half-width 0.5 whose middle is the right side of the box: its left half lies within.
    const SectionLine square{{{0.5, -0.5}, {1.5, -0.5}, {1.5, 0.5}, {0.5, 0.5}}, true};
    const auto pieces = piecesWithin(square, kBox);
    ASSERT_EQ(pieces.size(), 1U);
    EXPECT_FALSE(pieces[0].closed);
    EXPECT_NEAR(lengthOf(pieces), 2, 1e-12);
    const SectionLine inside{{{0, 0}, {0.5, 0}, {0, 0.5}}, true};
    ASSERT_EQ(piecesWithin(inside, kBox).size(), 1U);
    EXPECT_TRUE(piecesWithin(inside, kBox)[0].closed);
    const SectionLine across{{{-3, 0.25}, {3, 0.25}}, false};
    EXPECT_NEAR(lengthOf(piecesWithin(across, kBox)), 2, 1e-12);
    const SectionLine around{{{-3, -3}, {3, -3}, {3, 3}, {-3, 3}}, true};
    EXPECT_TRUE(piecesWithin(around, kBox).empty());
}

}  // namespace
}  // namespace tactooth
