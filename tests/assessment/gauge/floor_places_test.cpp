// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// The floor as the metrics of a preparation measure it, on blocks whose floor has a closed form.
#include "assessment/gauge/floor_places.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "assessment/preparation/prepared_blocks.h"
#include "geometry/mesh/subdivide.h"
#include "geometry/util/degree.h"

namespace tactooth {
namespace {

using namespace test;

constexpr double kLength = 0.02, kAngle = 0.5;  // what has to be reached: mm, degrees

CavityForm measured(const TriangleMesh& student) {
    const Preparation preparation = blockPreparation(student, blockWithBox(-2, 2, -1.5, 1.5, 3));
    return cavityForm(preparation, CutSurfaces(preparation));
}

double of(const Measured& measured) {
    EXPECT_TRUE(measured.value) << (measured.reason != nullptr ? measured.reason->english : "");
    return measured.value.value_or(-1e9);
}

/// A floor 4 mm long whose height at x is that of `heightAt`.
TriangleMesh blockWithHeights(const std::function<double(double x)>& heightAt) {
    std::vector<Vec2> profile;
    constexpr int kSteps = 200;
    for (int i = 0; i <= kSteps; ++i) {
        const double x = -2 + 4.0 * i / kSteps;
        profile.emplace_back(x, heightAt(x));
    }
    return blockWithFloorProfile(profile);
}

/// Grooves of a ball bur beside each other: the first one in the middle, 2 mm deep.
struct Grooves {
    double radius, pitch;

    [[nodiscard]] double heightAt(double x) const {
        const double from = x - pitch * std::round(x / pitch);
        return 3 + radius - std::sqrt(radius * radius - from * from);
    }
    /// Half of the floor lies within a quarter of the pitch of a groove.
    [[nodiscard]] double medianDepth() const { return 2 - radius + std::sqrt(radius * radius - pitch * pitch / 16); }
    /// Of the circle between -a and a, a being half of the pitch: root of its mean square less its squared mean.
    [[nodiscard]] double flatness() const {
        const double a = pitch / 2;
        const double mean =
            (a * std::sqrt(radius * radius - a * a) + radius * radius * std::asin(a / radius)) / (2 * a);
        return std::sqrt(radius * radius - a * a / 3 - mean * mean);
    }
    /// Of its steepest place, degrees.
    [[nodiscard]] double steepest() const { return std::asin(pitch / 2 / radius) / kDegree; }
};

TEST(FloorPlaces, OfBallBurGroovesHaveTheClosedFormOfTheCircle) {
    for (const Grooves& grooves : {Grooves{0.5, 0.4}, Grooves{0.5, 0.8}, Grooves{0.5, 0.9}, Grooves{0.7, 1.1}}) {
        SCOPED_TRACE(std::to_string(grooves.radius) + " mm, " + std::to_string(grooves.steepest()) + " degrees");
        const CavityForm scalloped = measured(blockWithHeights([&](double x) { return grooves.heightAt(x); }));
        EXPECT_NEAR(of(scalloped.floorDepth), grooves.medianDepth(), kLength);
        EXPECT_NEAR(of(scalloped.floorFlatness), grooves.flatness(), kLength);
        EXPECT_NEAR(of(scalloped.floorTilt), 0, kAngle);
        EXPECT_NEAR(of(scalloped.floorDepthMax), 2, kLength);
        // Places 0.05 mm apart may lie half of that beside a crest.
        const double crest = 5 - grooves.heightAt(grooves.pitch / 2);
        EXPECT_GE(of(scalloped.floorDepthMin), crest - 1e-3);
        EXPECT_LE(of(scalloped.floorDepthMin), crest + 1e-3 + 0.025 * std::tan(grooves.steepest() * kDegree));
    }
}

TEST(FloorPlaces, OfTiltedGroovesHaveTheTilt) {
    const Grooves grooves{0.5, 0.8};
    for (const double tilt : {3.0, 8.0, 15.0}) {
        const double slope = std::tan(tilt * kDegree);
        const CavityForm tilted = measured(blockWithHeights([&](double x) { return grooves.heightAt(x) + slope * x; }));
        EXPECT_NEAR(of(tilted.floorTilt), tilt, kAngle);
        EXPECT_NEAR(of(tilted.floorFlatness), grooves.flatness() * std::cos(tilt * kDegree), kLength);
    }
}

TEST(FloorPlaces, OfAFloorThatLeansAsFarAsAWallAreFound) {
    for (const double tilt : {25.0, 35.0, 43.0}) {
        const double slope = std::tan(tilt * kDegree);
        const CavityForm leaning = measured(blockWithHeights([&](double x) { return 3 + slope * x; }));
        EXPECT_NEAR(of(leaning.floorTilt), tilt, kAngle);
        EXPECT_NEAR(of(leaning.floorDepth), 2, kLength);
        EXPECT_NEAR(of(leaning.floorFlatness), 0, kLength);
    }
}

/// An uneven hand in both directions. Whole waves lie within the strip along the border.
TEST(FloorPlaces, OfAWavyFloorHaveTheAmplitudeAsFlatness) {
    constexpr double kHeight = 0.08;
    TriangleMesh wavy = subdivided(blockWithBox(-2, 2, -1.5, 1.5, 3), 5);
    for (Vec3f& vertex : wavy.vertices) {
        if (vertex.z() != 3) continue;
        const double along = std::sin(2 * std::numbers::pi * vertex.x() / 0.85);
        const double across = std::sin(2 * std::numbers::pi * vertex.y() / 0.8);
        vertex.z() += static_cast<float>(kHeight * (along + across));
    }
    EXPECT_NEAR(of(measured(wavy).floorFlatness), kHeight, kLength);
    EXPECT_NEAR(of(measured(wavy).floorDepth), 2, kLength);
}

TEST(FloorPlaces, OnBothSidesOfALowStepAreOneFloor) {
    constexpr double kStep = 0.3;
    const CavityForm stepped = measured(blockWithHeights([](double x) { return x < 0 ? 3 : 3 + kStep; }));
    EXPECT_NEAR(of(stepped.floorDepthMin), 2 - kStep, kLength);
    EXPECT_NEAR(of(stepped.floorDepthMax), 2, kLength);
    EXPECT_NEAR(of(stepped.floorFlatness), kStep / 4, kLength);  // of a step to the line nearest to it
}

/// The floor of a box, behind an axial wall, is another floor.
TEST(FloorPlaces, OnBothSidesOfAnAxialWallAreTwoFloors) {
    for (const double wall : {0.5, 1.3}) {
        const CavityForm box = measured(blockWithHeights([&](double x) { return x < 0.5 ? 3 : 3 - wall; }));
        EXPECT_NEAR(of(box.floorDepthMin), 2, kLength);
        EXPECT_NEAR(of(box.floorDepthMax), 2, kLength);
    }
}

TEST(FloorPlaces, OfASlotNarrowerThanTheStripAreThoseOfItsMiddle) {
    const CavityForm slot = measured(blockWithBox(-2, 2, -0.2, 0.2, 3.5));
    EXPECT_NEAR(of(slot.floorDepth), 1.5, kLength);
    EXPECT_NEAR(of(slot.floorFlatness), 0, kLength);
}

TEST(FloorPlaces, AreNoneWhereNothingFacesTheAxis) {
    const auto wedge = [](double x) { return std::min(4.9, 3 + std::abs(x) * std::tan(60 * kDegree)); };
    const CavityForm cut = measured(blockWithFloorProfile({{-1, wedge(-1)}, {0, wedge(0)}, {1, wedge(1)}}));
    for (const Measured* each : {&cut.floorDepth, &cut.floorDepthMin, &cut.floorFlatness, &cut.floorTilt}) {
        EXPECT_FALSE(each->value);
        EXPECT_EQ(each->reason->id, "no_floor");
    }
    EXPECT_TRUE(floorPlaces(TriangleMesh{}, Vec3::UnitZ()).empty());
}

}  // namespace
}  // namespace tactooth
