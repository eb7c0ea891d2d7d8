// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/tooth_in_mouth.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "collision/closest_point.h"
#include "support/few_teeth.h"

namespace tactooth {
namespace {

const ToothInMouth& premolar() {
    static const ToothInMouth made = *toothInMouth(
        35, std::nullopt,
        {.triangles = 2000, .jaw = JawPose::open, .missing = test::allTeethBut({11, 26, 33, 34, 35, 37})});
    return made;
}

TEST(ToothInMouth, StandsAmongAllOtherTeethAndBothGums) {
    EXPECT_EQ(premolar().tooth.fdi, 35);
    EXPECT_EQ(premolar().around.size(), 5u + 2u);
    EXPECT_EQ(std::ranges::count_if(premolar().around, &ToothInMouth::Body::isGum), 2);
    EXPECT_EQ(std::ranges::count_if(premolar().around, &ToothInMouth::Body::isOpposite), 2 + 1);
    EXPECT_EQ(surroundingsOf(premolar()).size(), premolar().around.size());
}

TEST(ToothInMouth, NeighboursAreInItsFrameAndTaggedByWhatTheyAreMadeOf) {
    double nearest = 1e9;
    for (const ToothInMouth::Body& body : premolar().around) {
        const auto material = static_cast<MaterialId>(body.part->tag(0));
        EXPECT_EQ(material, body.isGum ? MaterialId::Other : MaterialId::Enamel);
        if (body.isGum || body.isOpposite) continue;
        for (std::size_t i = 0; i < premolar().tooth.outer.vertices.size(); ++i) {
            const auto near =
                closestPoint(*body.part, premolar().tooth.outer.vertices[i].cast<double>(), std::min(nearest, 1.0));
            if (near) nearest = near->distance;
        }
    }
    EXPECT_LT(nearest, 0.15);  // it touches the one before it
    EXPECT_GT(nearest, 0.01);
}

TEST(ToothInMouth, OnlyWhatStandsOutOfTheGumIsDrawn) {
    const TriangleMesh shown = aboveTheGum(premolar().tooth.outer);
    EXPECT_LT(shown.triangles.size(), premolar().tooth.outer.triangles.size());
    EXPECT_LT(boundingBox(shown).min().z(), -0.9);
    EXPECT_GT(boundingBox(shown).min().z(), -4);
    EXPECT_EQ(boundingBox(shown).max().z(), boundingBox(premolar().tooth.outer).max().z());
}

TEST(ToothInMouth, DecayComesWithTheToothThatIsWorkedOn) {
    EXPECT_TRUE(premolar().tooth.caries.empty());
    int made = 0;
    const auto count = [&](const ToothRequest& request) {
        if (request.lesion) ++made;
        return makeTooth(request);
    };
    const ToothInMouth decayed = *toothInMouth(41, Lesion{LesionSite::mesial, 1.5, {}},
                                               {.triangles = 1000, .missing = test::allTeethBut({31, 41, 42})}, count);
    EXPECT_EQ(made, 1);
    EXPECT_FALSE(decayed.tooth.caries.empty());
}

}  // namespace
}  // namespace tactooth
