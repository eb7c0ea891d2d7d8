// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/surface/surface_intersection.h"

#include <gtest/gtest.h>

#include <random>

namespace tactooth {
namespace {

IntersectingFace face(const Vec3f& a, const Vec3f& b, const Vec3f& c) { return {{a, b, c}, {1, 2, 3}}; }

IntersectingFace randomFace(std::mt19937& random, int steps) {
    std::uniform_int_distribution<int> place(0, steps);
    const auto point = [&] { return Vec3f(place(random), place(random), place(random)); };
    return face(point(), point(), point());
}

IntersectingFace rotated(const IntersectingFace& f) {
    return {{f.corner[1], f.corner[2], f.corner[0]}, {f.id[1], f.id[2], f.id[0]}};
}

/// Whether edge ab of one face (by its ends) passes through `other`, for the parity of a closed surface.
bool runsThrough(const Vec3f& a, const Vec3f& b, const IntersectingFace& wall) {
    // A thin face with that edge. Its third corner is far off the wall.
    for (const Vec3f& away : {Vec3f(100, 101, 102), Vec3f(-90, 80, 123)}) {
        const auto crossing = intersectionOf(face(a, b, away), wall);
        if (!crossing) continue;
        for (const IntersectionPoint& point : {crossing->start, crossing->end}) {
            if (point.onBaseEdge && point.edge == 0) return true;
        }
    }
    return false;
}

TEST(SurfaceIntersection, TwoCrossedTrianglesMeetInASegment) {
    const auto base = face(Vec3f(-1, -1, 0), Vec3f(3, -1, 0), Vec3f(-1, 3, 0));
    const auto wall = face(Vec3f(0, 0, -1), Vec3f(0, 0.5F, 1), Vec3f(0, -0.5F, 1));
    const auto crossing = intersectionOf(base, wall);
    ASSERT_TRUE(crossing);
    EXPECT_FALSE(crossing->start.onBaseEdge);
    EXPECT_FALSE(crossing->end.onBaseEdge);
    const Vec3 segment = crossing->end.position - crossing->start.position;
    EXPECT_NEAR(segment.norm(), 0.5, 1e-9);
    const Vec3 normal = Vec3(0, 0.5, 2).cross(Vec3(0, -0.5, 2));
    const Vec3 left = Vec3::UnitZ().cross(segment);
    EXPECT_LT(left.dot(normal), 0);  // the kept part, behind the wall, is on the left
}

TEST(SurfaceIntersection, SeparateTrianglesDoNotCross) {
    const auto base = face(Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(0, 1, 0));
    EXPECT_FALSE(intersectionOf(base, face(Vec3f(0, 0, 1), Vec3f(1, 0, 1), Vec3f(0, 1, 2))));
    EXPECT_FALSE(intersectionOf(base, face(Vec3f(5, 5, -1), Vec3f(6, 5, 1), Vec3f(5, 6, 1))));
}

TEST(SurfaceIntersection, TheCutLinePassesThroughATriangleWithoutArea) {
    const auto base = face(Vec3f(-1, -1, 0), Vec3f(3, -1, 0), Vec3f(-1, 3, 0));
    const Vec3f below(0, 0, -1);
    const Vec3f above(0.5F, 0, 1);
    const auto crossing = intersectionOf(base, face(below, above, above));
    ASSERT_TRUE(crossing);
    EXPECT_EQ(crossing->end.edge, 0);
    EXPECT_EQ(crossing->start.edge, 2);
    EXPECT_EQ(crossing->start.position, crossing->end.position);
    EXPECT_FALSE(intersectionOf(base, face(above, above, above)));
}

TEST(SurfaceIntersection, TouchingFlatAndCoincidentTrianglesAreDecidedWithTwoEndsOrNone) {
    std::mt19937 random(21);
    int crossed = 0;
    for (int i = 0; i < 30'000; ++i) {  // on a grid of 4^3 places most pairs touch in a degenerate way
        const IntersectingFace base = randomFace(random, 3);
        const IntersectingFace wall = randomFace(random, 3);
        const auto crossing = intersectionOf(base, wall);
        const auto turned = intersectionOf(rotated(base), rotated(wall));
        ASSERT_EQ(crossing.has_value(), turned.has_value());
        crossed += crossing.has_value();
        if (!crossing) continue;
        EXPECT_EQ(crossing->start.position, turned->start.position);
        EXPECT_EQ(crossing->end.position, turned->end.position);
    }
    EXPECT_GT(crossed, 1000);
}

TEST(SurfaceIntersection, AnEdgeRunsThroughAClosedSurfaceEvenlyIfItsEndsAreOutside) {
    const Vec3f p[4] = {Vec3f(1, 1, 1), Vec3f(3, 1, 1), Vec3f(1, 3, 1), Vec3f(1, 1, 3)};
    const IntersectingFace sides[4] = {face(p[0], p[2], p[1]), face(p[0], p[1], p[3]), face(p[1], p[2], p[3]),
                                       face(p[0], p[3], p[2])};
    std::mt19937 random(22);
    std::uniform_int_distribution<int> place(0, 4);
    int through = 0;
    for (int i = 0; i < 5'000; ++i) {
        Vec3f a(place(random), place(random), place(random));
        Vec3f b(place(random), place(random), place(random));
        a.x() = 0;  // outside, on opposite sides; the line between grid points meets corners and edges often
        b.x() = 4;
        int count = 0;
        for (const IntersectingFace& side : sides) count += runsThrough(a, b, side);
        ASSERT_EQ(count % 2, 0);
        through += count > 0;
    }
    EXPECT_GT(through, 300);
}

}  // namespace
}  // namespace tactooth
