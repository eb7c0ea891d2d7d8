// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/head_outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/shapes.h"

namespace tactooth {
namespace {

constexpr double kRadius = 0.6, kLength = 4;  // mm
constexpr int kSides = 64;

RevolutionEnvelope cylinder() {
    return *RevolutionEnvelope::make(test::cylinder(Vec3::Zero(), kRadius, kLength, kSides));
}

/// Of the outline in the plane square to `inward`.
double areaOf(const std::vector<Vec3>& outline, const Vec3& inward) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < outline.size(); ++i) sum += outline[i].cross(outline[(i + 1) % outline.size()]);
    return std::abs(sum.dot(inward)) / 2;
}

TEST(HeadOutline, AlongTheShaftIsACircle) {
    const auto outline = HeadOutline(cylinder(), kLength).seenAlong(-Vec3::UnitZ(), Quat::Identity());
    ASSERT_EQ(outline.size(), std::size_t{HeadOutline::kPlaces});
    for (const Vec3& place : outline) {
        EXPECT_NEAR(place.norm(), kRadius, 0.01);
        EXPECT_NEAR(place.z(), 0, 1e-12);
    }
}

/// A cylinder that leans by an angle shows a rectangle with half an ellipse at each end: an area of 2 r l sin + pi r^2
/// cos.
TEST(HeadOutline, OfALeaningCylinderHasTheAreaOfItsSilhouette) {
    const HeadOutline head(cylinder(), kLength);
    for (const double lean : {0.2, 0.7, 1.2, std::numbers::pi / 2}) {
        for (const double turn : {0.0, 1.0, 2.5}) {
            const Quat tool(Eigen::AngleAxisd(turn, Vec3::UnitZ()) * Eigen::AngleAxisd(lean, Vec3::UnitX()));
            const Vec3 inward = -Vec3::UnitZ();
            const auto outline = head.seenAlong(inward, tool);
            const double area =
                2 * kRadius * kLength * std::sin(lean) + std::numbers::pi * kRadius * kRadius * std::cos(lean);
            EXPECT_NEAR(areaOf(outline, inward), area, 0.04 * area) << lean;
            for (const Vec3& place : outline) EXPECT_NEAR(place.dot(inward), 0, 1e-12);
        }
    }
}

/// Every place of the surface lies within the outline, for each bur and each direction, but for its corners: a right
/// angle between two places that are d apart along it loses d / sqrt(8).
TEST(HeadOutline, OfEachBurOfTheCatalogueEnclosesItsHead) {
    for (const BurSpec& spec : burCatalogue()) {
        const SessionBur bur = *makeSessionBur(spec);
        const HeadOutline head(bur);
        for (const double lean : {0.0, 0.6, 1.5}) {
            const Quat tool(Eigen::AngleAxisd(lean, Vec3(1, 2, 0).normalized()));
            const Vec3 inward = -Vec3::UnitZ();
            const auto outline = head.seenAlong(inward, tool);
            ASSERT_EQ(outline.size(), std::size_t{HeadOutline::kPlaces}) << spec.name;
            double outside = 0, whole = 0;
            for (std::size_t i = 0; i < outline.size(); ++i) {
                whole += (outline[(i + 1) % outline.size()] - outline[i]).norm();
            }
            const double corner = whole / HeadOutline::kPlaces / std::sqrt(8);
            for (const Vec3f& vertex : bur.shown->vertices) {
                if (vertex.z() > bur.head.length) continue;
                const Vec3 place = tool * vertex.cast<double>();
                for (std::size_t i = 0; i < outline.size(); ++i) {
                    const Vec3 edge = outline[(i + 1) % outline.size()] - outline[i];
                    const Vec3 outward = edge.cross(inward).normalized();
                    outside = std::max(outside, outward.dot(place - outline[i]));
                }
            }
            EXPECT_LT(outside, 1.1 * corner + 0.01) << spec.name << " leaning by " << lean;
        }
    }
}

TEST(HeadOutline, OfAHandInstrumentIsThatOfItsWorkingEnd) {
    for (const HandInstrumentSpec& spec : handInstruments()) {
        const auto outline = HeadOutline(makeHandInstrument(spec.kind)).seenAlong(-Vec3::UnitZ(), Quat::Identity());
        ASSERT_EQ(outline.size(), std::size_t{HeadOutline::kPlaces});
        for (const Vec3& place : outline) EXPECT_NEAR(place.norm(), spec.headRadius, 0.02);
    }
}

}  // namespace
}  // namespace tactooth
