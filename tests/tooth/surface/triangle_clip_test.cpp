// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/surface/triangle_clip.h"

#include <gtest/gtest.h>

namespace tactooth {
namespace {

const std::array<Vec3, 3> kCorners = {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
const std::array<bool, 3> kForward = {true, true, false};
const std::array<bool, 3> kKept = {true, true, true};  // whether the corners are kept
const std::array<bool, 3> kGone = {false, false, false};

ClipPoint onEdge(int edge, double along) {
    const Vec3& from = kCorners[edge];
    const Vec3& to = kCorners[(edge + 1) % 3];
    const double share = kForward[edge] ? along : 1 - along;
    return {from + share * (to - from), edge, along, 0, {}};
}
ClipPoint inside(double x, double y, std::uint64_t key) { return {Vec3(x, y, 0), -1, 0, 0, {key, key}}; }

double area(const ClippedTriangle& clipped) {
    double sum = 0;
    for (const Triangle& t : clipped.triangles) {
        sum +=
            0.5 * (clipped.points[t[1]] - clipped.points[t[0]]).cross(clipped.points[t[2]] - clipped.points[t[0]]).z();
    }
    return sum;
}

std::vector<ClipSegment> square(double x0, double y0, double side, bool counterClockwise) {
    std::vector<ClipPoint> p = {inside(x0, y0, 1), inside(x0 + side, y0, 2), inside(x0 + side, y0 + side, 3),
                                inside(x0, y0 + side, 4)};
    if (!counterClockwise) std::swap(p[1], p[3]);
    return {{p[0], p[1]}, {p[1], p[2]}, {p[2], p[3]}, {p[3], p[0]}};
}

TEST(TriangleClip, WithoutLinesTheCornersDecide) {
    EXPECT_EQ(area(*clipTriangle(kCorners, kForward, {}, kKept)), 8);
    EXPECT_TRUE(clipTriangle(kCorners, kForward, {}, kGone)->triangles.empty());
}

TEST(TriangleClip, ALineFromEdgeToEdgeLeavesItsLeftSide) {
    const ClipPoint bottom = onEdge(0, 0.5);
    const ClipPoint slope = onEdge(1, 0.5);
    EXPECT_NEAR(area(*clipTriangle(kCorners, kForward, {{bottom, slope}}, kGone)), 6, 1e-12);
    EXPECT_NEAR(area(*clipTriangle(kCorners, kForward, {{slope, bottom}}, kGone)), 2, 1e-12);
}

TEST(TriangleClip, ALineMayBendInside) {
    const ClipPoint bottom = onEdge(0, 0.5);
    const ClipPoint left = onEdge(2, 0.5);
    const ClipPoint bend = inside(2, 2 - 1e-9, 7);
    EXPECT_NEAR(area(*clipTriangle(kCorners, kForward, {{left, bend}, {bend, bottom}}, kGone)), 4, 1e-6);
    EXPECT_NEAR(area(*clipTriangle(kCorners, kForward, {{bottom, bend}, {bend, left}}, kGone)), 4, 1e-6);
}

TEST(TriangleClip, ALineThatReturnsToItsEdgeCutsABite) {
    const ClipPoint a = onEdge(0, 0.25);
    const ClipPoint b = onEdge(0, 0.75);
    const ClipPoint top = inside(2, 1, 5);
    EXPECT_NEAR(area(*clipTriangle(kCorners, kForward, {{a, top}, {top, b}}, kKept)), 7, 1e-12);
    EXPECT_NEAR(area(*clipTriangle(kCorners, kForward, {{b, top}, {top, a}}, kGone)), 1, 1e-12);
}

TEST(TriangleClip, AClosedLineIsAHoleOrAnIsland) {
    EXPECT_NEAR(area(*clipTriangle(kCorners, kForward, square(0.5, 0.5, 1, false), kKept)), 7, 1e-12);
    EXPECT_NEAR(area(*clipTriangle(kCorners, kForward, square(0.5, 0.5, 1, true), kGone)), 1, 1e-12);
}

TEST(TriangleClip, TwoHolesAreBothCutOut) {
    auto lines = square(0.5, 0.5, 0.5, false);
    for (ClipSegment segment : square(1.5, 0.5, 0.5, false)) {
        for (ClipPoint* point : {&segment.start, &segment.end}) point->key[0] += 100;
        lines.push_back(segment);
    }
    EXPECT_NEAR(area(*clipTriangle(kCorners, kForward, lines, kKept)), 7.5, 1e-12);
}

TEST(TriangleClip, InconsistentLinesAreRefused) {
    EXPECT_FALSE(clipTriangle(kCorners, kForward, {{onEdge(0, 0.5), inside(1, 1, 1)}}, kKept));
    const std::vector<ClipSegment> bothLeave = {{onEdge(0, 0.3), onEdge(1, 0.3)}, {onEdge(0, 0.6), onEdge(1, 0.6)}};
    EXPECT_FALSE(clipTriangle(kCorners, kForward, bothLeave, kKept));
}

// A wall that is folded over itself at an edge may leave the triangle just before it enters it.
TEST(TriangleClip, TheCornersDecideWhereAFoldedLineSwaps) {
    const ClipPoint a = onEdge(1, 0.5);
    const ClipPoint b = onEdge(1, 0.5 + 1e-4);
    const ClipPoint tip = inside(1.5, 1.5, 5);
    const std::vector<ClipSegment> fold = {{a, tip}, {tip, b}};
    const ClipPoint bottom = onEdge(0, 0.5);
    const ClipPoint left = onEdge(2, 0.5);
    EXPECT_NEAR(area(*clipTriangle(kCorners, kForward, fold, kKept)), 8, 1e-3);
    EXPECT_NEAR(area(*clipTriangle(kCorners, kForward, fold, kGone)), 0, 1e-3);
    // One of two lines. The other one keeps the corner that is far from the fold.
    const std::vector<ClipSegment> both = {{a, tip}, {tip, b}, {bottom, left}};
    EXPECT_FALSE(clipTriangle(kCorners, kForward, both, kKept));
    const auto cut = clipTriangle(kCorners, kForward, both, {true, false, false});
    ASSERT_TRUE(cut);
    EXPECT_NEAR(area(*cut), 2, 1e-3);
}

TEST(TriangleClip, CrossingsThatRoundingSwappedAlternateAgain) {
    std::vector<EdgeCrossing> crossings = {{0.1, 1, true, 0}, {0.5, 2, true, 1}, {0.5000001, 3, false, 2}};
    EXPECT_EQ(exitSurplus(crossings), 1);
    ASSERT_TRUE(sortCrossings(crossings, false));
    EXPECT_EQ(crossings[0].segment, 0U);
    EXPECT_EQ(crossings[1].segment, 2U);
    EXPECT_EQ(crossings[2].segment, 1U);
}

TEST(TriangleClip, WhereAsManyCrossingsLeaveAsEnterTheFirstEndDecides) {
    const std::vector<EdgeCrossing> crossings = {{0.1, 1, true, 0}, {0.1000001, 2, false, 1}};
    EXPECT_EQ(exitSurplus(crossings), 0);
    std::vector<EdgeCrossing> kept = crossings;
    ASSERT_TRUE(sortCrossings(kept, true));
    EXPECT_EQ(kept[0].segment, 0U);
    std::vector<EdgeCrossing> gone = crossings;
    ASSERT_TRUE(sortCrossings(gone, false));
    EXPECT_EQ(gone[0].segment, 1U);
}

}  // namespace
}  // namespace tactooth
