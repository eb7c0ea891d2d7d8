// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/mouth/tooth_arrangement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/field/isosurface.h"

namespace tactooth {
namespace {

const ToothArrangement& places() {
    static const ToothArrangement arranged = arrangeTeeth(0);
    return arranged;
}

std::vector<Vec3f> surfaceOf(const ToothShape& shape) {
    return isosurface(shape.outer, shape.bounds, {.cellSize = 0.33, .lipschitzBound = 1.3}).vertices;
}

/// From the neck to the edge or the highest cusp, mm.
double crownHeight(const std::vector<Vec3f>& surface) {
    return std::ranges::max(surface, {}, [](const Vec3f& v) { return v.z(); }).z();
}

/// The level of a contact at its distal tooth: 0 at the edge, 1 at the neck.
double levelOf(const JawQuadrant& side, std::size_t place) {
    const PlacedShape& tooth = side.teeth[place];
    const double height = crownHeight(surfaceOf(tooth.shape));
    return 1 - (tooth.shapeInMouth.inverse() * side.contacts[place].point).z() / height;
}

TEST(ToothArrangement, ContactsAreAtTheLevelsOfTextbooks) {
    // Incisal third between the incisors, the junction to the middle third at the upper canine, the occlusal or middle
    // third farther back; none in the cervical third, where it would open a gap above it.
    constexpr double kTolerance = 0.04, kThird = 1.0 / 3;
    for (const JawQuadrant* side : {&places().upper, &places().lower}) {
        for (std::size_t place = 0; place < kTeethPerQuadrant; ++place) {
            const double lowest = place < 3 ? kThird : 2 * kThird;
            EXPECT_LT(levelOf(*side, place), lowest + kTolerance) << (side->upper ? 11 : 31) + place;
            EXPECT_GT(levelOf(*side, place), 0.1) << (side->upper ? 11 : 31) + place;
        }
    }
}

TEST(ToothArrangement, UpperCentralIncisorsStandSideBySideAndNotInAWedge) {
    // The incisal edge is level, and the mesial faces are as close at the middle of the crown as at the edge.
    const PlacedShape& tooth = places().upper.teeth[0];
    const Vec3 edge = tooth.shapeInMouth.rotation * Vec3::UnitX();
    EXPECT_LT(std::abs(edge.z()), 0.07);  // 4 degrees
    const std::vector<Vec3f> surface = surfaceOf(tooth.shape);
    const double edgeAt = crownHeight(surface);
    const auto toMidline = [&](double below) {
        double least = 1e9;
        for (const Vec3f& v : surface) {
            if (std::abs(v.z() - (edgeAt - below)) > 0.3) continue;
            least = std::min(least, (tooth.shapeInMouth * v.cast<double>()).x());
        }
        return least;
    };
    EXPECT_LT(std::abs(toMidline(2) - toMidline(5)), 0.1);
}

}  // namespace
}  // namespace tactooth
