// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/simulation/tooth_in_mouth.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "collision/bvh/closest_point.h"
#include "support/few_teeth.h"
#include "support/materials.h"

namespace tactooth {
namespace {

const ToothInMouth& premolar() {
    static const ToothInMouth made = *toothInMouth(
        35, std::nullopt,
        {.triangles = 2000, .jaw = JawPose::Open, .missing = test::allTeethExcept({11, 26, 33, 34, 35, 37})});
    return made;
}

TEST(ToothInMouth, StandsAmongAllOtherTeethAndBothGums) {
    EXPECT_EQ(premolar().tooth.fdi, 35);
    ASSERT_EQ(premolar().beside.size(), 1u);  // 36 is lost
    EXPECT_EQ(premolar().beside[0].fdi, 34);
    EXPECT_EQ(premolar().around.size(), 4u + 2u);
    EXPECT_EQ(std::ranges::count_if(premolar().around, &ToothInMouth::Body::isGingiva), 2);
    EXPECT_EQ(std::ranges::count_if(premolar().around, &ToothInMouth::Body::isOpposite), 2 + 1);
    EXPECT_EQ(surroundingsOf(premolar()).size(), premolar().around.size());
}

double gapBetween(const TriangleMesh& a, const SurfacePart& b) {
    double nearest = 1;
    for (const Vec3f& vertex : a.vertices) {
        if (const auto near = closestPoint(b, vertex.cast<double>(), nearest)) nearest = near->distance;
    }
    return nearest;
}

TEST(ToothInMouth, NeighboursAreInItsFrameAndTaggedByWhatTheyAreMadeOf) {
    for (const ToothInMouth::Body& body : premolar().around) {
        const auto material = static_cast<MaterialId>(body.part->tag(0));
        EXPECT_EQ(material, body.isGingiva ? test::kOther : test::kEnamel);
        EXPECT_TRUE(body.part->isAdjacent(0));
        if (!body.isGingiva) {
            EXPECT_EQ(gapBetween(premolar().tooth.outer, *body.part), 1) << "they are not next to it";
        }
    }
    const double gap = gapBetween(premolar().tooth.outer, SurfacePart(premolar().beside[0].outer));
    EXPECT_LT(gap, 0.15);  // it touches the one before it
    EXPECT_GT(gap, 0.01);
}

std::vector<Vec3> trianglesOf(const TriangleMesh& mesh) {
    std::vector<Vec3> corners;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (int corner = 0; corner < 3; ++corner) corners.push_back(mesh.corner(t, corner));
    }
    return corners;
}

TEST(ToothInMouth, IsCutTogetherWithTheTeethBesideIt) {
    const LayeredTooth alone = *layeredTooth(premolar().tooth);
    const LayeredTooth both = *layeredTooth(premolar());
    EXPECT_EQ(both.toothContext().firstAdjacent, alone.outer()->mesh().triangles.size());
    EXPECT_EQ(trianglesOf(both.ownOuter()->mesh()), trianglesOf(alone.outer()->mesh()));
    EXPECT_EQ(both.ownOuter()->tags(), alone.outer()->tags());
    EXPECT_EQ(both.ownBox().max(), alone.ownBox().max());
    EXPECT_EQ(both.layers().size(), 2 * alone.layers().size());
    // What lies behind its neighbour's surface is known as well.
    const SurfacePart& outer = *both.outer();
    const auto from = outer.tags().begin() + both.toothContext().firstAdjacent;
    EXPECT_GT(std::count(from, outer.tags().end(), static_cast<SurfaceTag>(test::kEnamel)), 300);
    EXPECT_GT(std::count(from, outer.tags().end(), static_cast<SurfaceTag>(test::kDentin)), 300);
}

TEST(ToothInMouth, TheAnteriorTeethOfBothSidesAreBesideEachOther) {
    const ToothInMouth incisor =
        *toothInMouth(41, std::nullopt, {.triangles = 1000, .missing = test::allTeethExcept({11, 31, 32, 41, 42, 48})});
    ASSERT_EQ(incisor.beside.size(), 2u);
    EXPECT_EQ(incisor.beside[0].fdi, 31);
    EXPECT_EQ(incisor.beside[1].fdi, 42);
}

TEST(ToothInMouth, OnlyWhatStandsOutOfTheGumIsDrawn) {
    const TriangleMesh shown = supragingivalMesh(premolar().tooth.outer);
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
    const ToothInMouth decayed =
        *toothInMouth(41, Lesion{LesionSite::Mesial, 1.5, {}},
                      {.triangles = 1000, .missing = test::allTeethExcept({31, 41, 42})}, count);
    EXPECT_EQ(made, 1);
    EXPECT_FALSE(decayed.tooth.caries.empty());
}

}  // namespace
}  // namespace tactooth
