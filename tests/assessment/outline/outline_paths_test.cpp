// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/outline/outline_paths.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "assessment/outline/flat_outline.h"
#include "assessment/outline/outline_templates.h"
#include "collision/bvh/closest_point.h"
#include "geometry/mesh/mesh_report.h"
#include "geometry/util/degree.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

/// A block of enamel, 10 mm wide, with its top at z = 5.
std::shared_ptr<const LayeredTooth> block() {
    return std::make_shared<const LayeredTooth>(*LayeredTooth::make(test::box(Vec3(-5, -5, -5), Vec3(5, 5, 5))));
}

/// An exercise below this outline, for a bur of 1 mm with a flat end.
Exercise outlined(std::vector<Vec3> corners, double depth, double taperDegrees = 0) {
    Exercise exercise;
    exercise.bur = std::string("57");
    exercise.ideal = PreparationPlan{
        .outward = Vec3::UnitZ(),
        .depth = depth,
        .isFlat = true,
        .strokes = {},
        .fissure = {},
        .boxes = {},
        .body = {},
        .outline = DrawnOutline{
            .corners = std::move(corners), .taperDegrees = taperDegrees, .burRadius = 0.5, .burLength = 4.2}};
    return exercise;
}

std::vector<Vec3> rectangle(double length, double width) {
    return {{-length / 2, -width / 2, 5},
            {length / 2, -width / 2, 5},
            {length / 2, width / 2, 5},
            {-length / 2, width / 2, 5}};
}

double removedVolume(const Exercise& exercise, const std::shared_ptr<const LayeredTooth>& tooth) {
    const auto ideal = idealShape(exercise, tooth);
    EXPECT_TRUE(ideal) << ideal.error().message();
    if (!ideal) return 0;
    EXPECT_TRUE(reportOn(*ideal).watertight());
    return *reportOn(tooth->ownOuter()->mesh()).volume() - *reportOn(*ideal).volume();
}

/// A bur of radius 0.5 leaves the four corners round.
constexpr double kCorners = (4 - std::numbers::pi) * 0.25;

TEST(OutlinePaths, CutTheVolumeBelowTheOutline) {
    for (const double depth : {1.0, 2.0}) {
        const double expected = (4 * 2.5 - kCorners) * depth;
        EXPECT_NEAR(removedVolume(outlined(rectangle(4, 2.5), depth), block()), expected, 0.03 * expected);
    }
}

/// Where it is looked at clockwise.
TEST(OutlinePaths, DoNotDependOnTheDirectionOfTheOutline) {
    std::vector<Vec3> corners = rectangle(4, 2.5);
    const double volume = removedVolume(outlined(corners, 1), block());
    std::ranges::reverse(corners);
    EXPECT_NEAR(removedVolume(outlined(corners, 1), block()), volume, 0.01 * volume);
}

TEST(OutlinePaths, LeanTheWallsByTheTaper) {
    for (const double degrees : {6.0, 20.0}) {
        const double in = 2 * std::tan(degrees * kDegree);  // on both sides, for each mm of depth
        const double depth = 1.5;
        const auto areaAt = [&](double below) { return (4 - in * below) * (3 - in * below) - kCorners; };
        const double expected = depth / 6 * (areaAt(0) + 4 * areaAt(depth / 2) + areaAt(depth));  // exact: a parabola
        EXPECT_NEAR(removedVolume(outlined(rectangle(4, 3), depth, degrees), block()), expected, 0.03 * expected);
    }
}

/// Two lobes beside each other: the bur may not take the short way through what is between them.
TEST(OutlinePaths, LeaveWhatStandsBetweenTwoLobes) {
    const std::vector<Vec3> corners = {{-2, -2, 5},    {2, -2, 5},      {2, 2, 5},    {0.3, 2, 5},
                                       {0.3, -0.6, 5}, {-0.3, -0.6, 5}, {-0.3, 2, 5}, {-2, 2, 5}};
    const Exercise exercise = outlined(corners, 1.5);
    const auto ideal = idealShape(exercise, block());
    ASSERT_TRUE(ideal) << ideal.error().message();
    const SurfacePart shape(*ideal);
    const FlatOutline outline(corners, Vec3::UnitZ());
    int inside = 0, outside = 0;
    for (double x = -2.45; x < 2.5; x += 0.1) {
        for (double y = -2.45; y < 2.5; y += 0.1) {
            const auto point = outline.flat(Vec3(x, y, 0));
            const double away = outline.distance(point);
            if (away < 0.1) continue;
            const bool isCut = signedDistance(shape, Vec3(x, y, 4.5)) > 0;
            EXPECT_TRUE(!isCut || outline.contains(point)) << x << ' ' << y;
            (isCut ? inside : outside) += 1;
        }
    }
    EXPECT_GT(inside, 900);
    EXPECT_GT(outside, 500);
}

TEST(OutlinePaths, FollowTheSurfaceWhereTheFloorDoes) {
    Exercise exercise = outlined({{-1.5, 5, -1}, {1.5, 5, -1}, {1.5, 5, 1}, {-1.5, 5, 1}}, 0.8);
    auto& plan = std::get<PreparationPlan>(exercise.ideal);
    plan.outward = Vec3::UnitY();
    plan.isFlat = false;
    const auto tooth =
        std::make_shared<const LayeredTooth>(*LayeredTooth::make(test::sphere(Vec3::Zero(), 5, 200, 150)));
    const auto ideal = idealShape(exercise, tooth);
    ASSERT_TRUE(ideal) << ideal.error().message();
    const SurfacePart shape(*ideal);
    for (const double x : {-0.8, 0.0, 0.8}) {
        const double surface = std::sqrt(25 - x * x);
        EXPECT_GT(signedDistance(shape, Vec3(x, surface - 0.7, 0)), 0) << x;
        EXPECT_LT(signedDistance(shape, Vec3(x, surface - 1.0, 0)), 0) << x;
    }
}

TEST(OutlinePaths, NeedRoomForTheBurOnTheTooth) {
    const auto sentence = [](const Exercise& exercise) { return idealShape(exercise, block()).error().message(); };
    Exercise narrow = outlined(rectangle(4, 0.9), 1);
    EXPECT_THAT(sentence(narrow), testing::StartsWith("the outline is narrower than the bur"));
    narrow.file = "narrow.toml";
    EXPECT_THAT(sentence(narrow), testing::StartsWith("narrow.toml: the outline is narrower than the bur"));
    std::vector<Vec3> beside = rectangle(4, 2);
    for (Vec3& corner : beside) corner.x() += 20;
    EXPECT_THAT(sentence(outlined(beside, 1)), testing::HasSubstr("beside the tooth"));
    Exercise boxed = outlined(rectangle(4, 2), 1);
    std::get<PreparationPlan>(boxed.ideal).boxes = {{.towardX = 1, .width = 2.5, .axialDepth = 1.2, .axialHeight = 1}};
    EXPECT_THAT(sentence(boxed), testing::HasSubstr("does not reach its box"));
}

TEST(OutlinePaths, TellWhichShareIsCutAndEndWhenNobodyWantsMore) {
    const Exercise exercise = outlined(rectangle(4, 2.5), 1);
    std::vector<double> shares;
    const auto ideal = idealShape(exercise, block(), [&](double share) {
        shares.push_back(share);
        return true;
    });
    ASSERT_TRUE(ideal) << ideal.error().message();
    EXPECT_FALSE(ideal->empty());
    ASSERT_GT(shares.size(), 10U);
    EXPECT_TRUE(std::ranges::is_sorted(shares));
    EXPECT_EQ(shares.front(), 0);
    EXPECT_GT(shares.back(), 0.9);
    EXPECT_LE(shares.back(), 1);
    int calls = 0;
    const auto ended = idealShape(exercise, block(), [&](double) { return ++calls < 5; });
    ASSERT_TRUE(ended);
    EXPECT_TRUE(ended->empty());
    EXPECT_EQ(calls, 5);
}

TEST(OutlinePaths, EndInABoxThatOpensTheSide) {
    const double width = 2, boxWidth = 3, axial = 1.4, height = 1.2, depth = 1.5;
    std::vector<Vec3> corners = rectangle(6, width);
    for (Vec3& corner : corners) corner.x() += 1.1;  // from -1.9 to 4.1; the axial wall is at 3.6
    Exercise exercise = outlined(corners, depth);
    std::get<PreparationPlan>(exercise.ideal).boxes = {
        {.towardX = 1, .width = boxWidth, .axialDepth = axial, .axialHeight = height}};
    const double round = (4 - std::numbers::pi) * 0.25 / 2;  // of two corners
    const double occlusal = ((3.6 + 1.9) * width - round) * depth;
    const double box = (axial * boxWidth - round) * (depth + height);
    EXPECT_NEAR(removedVolume(exercise, block()), occlusal + box, 0.03 * (occlusal + box));
    double lowest = 5;  // of what was cut
    const auto shape = idealShape(exercise, block());
    for (const Vec3f& vertex : shape->vertices) {
        if (vertex.z() > -4) lowest = std::min<double>(lowest, vertex.z());
    }
    EXPECT_NEAR(lowest, 5 - depth - height, 0.03);
}

TEST(OutlineTemplates, FollowTheFissureAsItsOwnPlanDoes) {
    for (const char* id : {"class-1-36", "class-2-36-do", "class-2-45-mo"}) {
        const Exercise original = *builtinExercise(id);
        const auto tooth = *exerciseTooth(original);
        Exercise drawn = original;
        auto& plan = std::get<PreparationPlan>(drawn.ideal);
        plan.outline = {.corners = fissureOutlineOn(plan, tooth->ownOuter()),
                        .taperDegrees = 0,
                        .burRadius = 0.4,
                        .burLength = 2.7};
        plan.fissure.reset();
        ASSERT_GE(plan.outline->corners.size(), 6U);
        EXPECT_FALSE(FlatOutline(plan.outline->corners, plan.outward).crossesItself());
        for (const Vec3& corner : plan.outline->corners)
            EXPECT_LT(std::abs(signedDistance(*tooth->ownOuter(), corner)), 1e-3);
        const double volume = removedVolume(original, tooth);
        EXPECT_NEAR(removedVolume(drawn, tooth), volume, 0.2 * volume) << id;
    }
}

TEST(OutlineTemplates, LieAtTheNeckOnBothSides) {
    const auto tooth = *exerciseTooth(*builtinExercise("class-5-34"));
    for (const double toward : {1.0, -1.0}) {
        const std::vector<Vec3> corners = neckOutlineOn(tooth->ownOuter(), toward);
        ASSERT_EQ(corners.size(), 10U);
        const FlatOutline outline(corners, toward * Vec3::UnitY());
        EXPECT_FALSE(outline.crossesItself());
        EXPECT_TRUE(outline.hasRoomFor(0.5));
        for (const Vec3& corner : corners) EXPECT_GT(toward * corner.y(), 0);
    }
}

}  // namespace
}  // namespace tactooth
