// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "patient/tooth_frame.h"

#include <gtest/gtest.h>

#include "geometry/mesh/subdivide.h"
#include "geometry/util/degree.h"
#include "instruments/builtin_tooth.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

const TriangleMesh& molar() {
    static const TriangleMesh mesh = makeTooth({.fdi = 36, .triangles = 4000, .seed = 0, .lesion = {}}).outer;
    return mesh;
}

Quat turn(double degrees, const Vec3& axis) { return Quat(Eigen::AngleAxisd(degrees * kDegree, axis.normalized())); }

TEST(ToothFrame, AToothThatStandsKeepsItsAxes) {
    const Quat lean = turn(12, Vec3(1, 1, 0));
    const FrameGuess guess = guessToothFrame(transformed(molar(), {Vec3(30, -4, 9), lean}));
    EXPECT_LT(guess.toothInFile.rotation.angularDistance(Quat::Identity()), 1e-9);
    EXPECT_LT((guess.toothInFile.position - Vec3(30, -4, 9)).norm(), 4);
}

TEST(ToothFrame, AToothThatLiesIsTurnedCrownUp) {
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, -1, 0.2)}) {
        for (const double degrees : {60.0, 90.0, 150.0, 180.0}) {
            const Quat lie = turn(degrees, axis);
            const FrameGuess guess = guessToothFrame(transformed(molar(), {Vec3(5, 5, 5), lie}));
            const Vec3 crown = guess.toothInFile.rotation * Vec3::UnitZ();
            EXPECT_GT(crown.dot(lie * Vec3::UnitZ()), std::cos(12 * kDegree))
                << degrees << " about " << axis.transpose();
        }
    }
}

TEST(ToothFrame, TheEnamelDecidesTheCrown) {
    // For a body that is the same at both ends only the hint says which one is up.
    FrameHints hints;
    hints.crown = Vec3(0, 0, -1);
    const FrameGuess guess = guessToothFrame(molar(), hints);
    EXPECT_LT((guess.toothInFile.rotation * Vec3::UnitZ()).z(), -0.9);
}

TEST(ToothFrame, TheCheekIsWhereTheArchSaysIt) {
    FrameHints hints;
    hints.buccal = Vec3(1, 0.1, 0.3);
    const FrameGuess guess = guessToothFrame(molar(), hints);
    EXPECT_GT((guess.toothInFile.rotation * Vec3::UnitY()).x(), 0.95);
    EXPECT_GT((guess.toothInFile.rotation * Vec3::UnitZ()).z(), 0.95);
}

TEST(ToothFrame, ACheekAlongTheLongAxisDecidesNothing) {
    const FrameGuess plain = guessToothFrame(molar());
    FrameHints hints;
    for (const Vec3& along : {Vec3(plain.toothInFile.rotation * Vec3::UnitZ()), Vec3(Vec3::Zero())}) {
        hints.buccal = along;
        const FrameGuess guess = guessToothFrame(molar(), hints);
        EXPECT_TRUE(guess.toothInFile.rotation.isApprox(plain.toothInFile.rotation, 1e-12));
    }
}

TEST(ToothFrame, WhatAPersonChoosesIsDone) {
    FrameHints hints;
    hints.isFlipped = true;
    hints.turn = 90 * kDegree;
    const FrameGuess guess = guessToothFrame(molar(), hints);
    EXPECT_LT((guess.toothInFile.rotation * Vec3::UnitZ()).z(), -0.9);
    EXPECT_EQ(inWords(guess.why.back()), "Turned by 90 degrees about the long axis, as chosen.");
}

TEST(ToothFrame, TheOriginIsAtTheNeck) {
    const FrameGuess guess = guessToothFrame(molar());
    EXPECT_NEAR(guess.toothInFile.position.z(), 0, 2.5);  // the neck of the built-in teeth
}

TEST(ToothFrame, TheTiltIsTheAngleOfTheCrownToZ) {
    const double own = crownTilt(molar()).value();
    EXPECT_LT(own, 12 * kDegree);
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, -1, 0)}) {
        for (const double degrees : {25.0, 60.0, 90.0, 150.0, 180.0}) {
            const TriangleMesh turned = transformed(molar(), {Vec3(5, 5, 5), turn(degrees, axis)});
            EXPECT_NEAR(crownTilt(turned).value(), degrees * kDegree, own + 1e-6) << degrees;
        }
    }
}

TEST(ToothFrame, OnlyAToothThatLiesHasANoteOnItsTilt) {
    for (const double degrees : {0.0, 15.0}) {
        EXPECT_FALSE(noteOnTilt(transformed(molar(), {Vec3::Zero(), turn(degrees, Vec3(1, 0, 0))}))) << degrees;
    }
    for (const double degrees : {50.0, 90.0, 180.0}) {
        EXPECT_TRUE(noteOnTilt(transformed(molar(), {Vec3::Zero(), turn(degrees, Vec3(1, 0, 0))}))) << degrees;
    }
}

TEST(ToothFrame, TheTiltDoesNotDependOnTheMesh) {
    TriangleMesh wedge = test::box(Vec3(-2, -6, -2), Vec3(2, 6, 2));  // twelve triangles
    for (Vec3f& vertex : wedge.vertices) {
        if (vertex.y() > 0) vertex = Vec3f(vertex.x() / 2, vertex.y(), vertex.z() / 2);
    }
    EXPECT_NEAR(crownTilt(wedge).value(), 90 * kDegree, 1e-6);
    EXPECT_NEAR(crownTilt(subdivided(wedge, 3)).value(), 90 * kDegree, 1e-6);
}

TEST(ToothFrame, ABodyThatIsTheSameAtBothEndsHasNoTilt) {
    EXPECT_FALSE(crownTilt(test::box(Vec3(0, 0, 0), Vec3(1, 1, 5))));
    EXPECT_FALSE(crownTilt(test::box(Vec3(0, 0, 0), Vec3(5, 5, 5))));
}

}  // namespace
}  // namespace tactooth
