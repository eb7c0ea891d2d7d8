// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/builtin_mouth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>

#include "collision/bvh/closest_point.h"
#include "geometry/mesh/mesh_report.h"
#include "instruments/mesh_checks.h"
#include "instruments/mouth/tooth_arrangement.h"
#include "instruments/mouth_checks.h"
#include "instruments/mouth_layout.h"
#include "support/few_teeth.h"
#include "support/mesh_checks.h"

namespace tactooth {
namespace {

using test::between;
using test::placed;

constexpr int kTriangles = 4000;

const BuiltinMouth& mouth() {
    static const BuiltinMouth made = *makeMouth({.triangles = kTriangles, .missing = {}});
    return made;
}

TEST(BuiltinMouth, HasAllTeethInTheOrderOfADentistsChart) {
    ASSERT_EQ(mouth().teeth.size(), 32u);
    EXPECT_EQ(mouth().teeth[0].tooth.fdi, 18);
    EXPECT_EQ(mouth().teeth[7].tooth.fdi, 11);
    EXPECT_EQ(mouth().teeth[8].tooth.fdi, 21);
    EXPECT_EQ(mouth().teeth[16].tooth.fdi, 38);
    EXPECT_EQ(mouth().teeth[31].tooth.fdi, 48);
    EXPECT_EQ(mouth().find(46)->tooth.name, "Lower right first molar");
    EXPECT_EQ(mouth().find(99), nullptr);
}

TEST(BuiltinMouth, TeethStandOnTheirSideWithTheCrownsTowardEachOther) {
    for (const MouthTooth& tooth : mouth().teeth) {
        const int quadrant = tooth.tooth.fdi / 10;
        const bool right = quadrant == 1 || quadrant == 4;
        EXPECT_EQ(tooth.toothInMouth.position.x() > 0, right) << tooth.tooth.fdi;
        const Vec3 crown = tooth.toothInMouth.rotation * Vec3::UnitZ();
        EXPECT_EQ(crown.z() > 0, quadrant > 2) << tooth.tooth.fdi;
        const Vec3 mesial = tooth.toothInMouth.rotation * (mesialX(tooth.tooth.fdi) * Vec3::UnitX());
        EXPECT_GT(right ? -mesial.x() + mesial.y() : mesial.x() + mesial.y(), 0.5) << tooth.tooth.fdi;
    }
}

TEST(BuiltinMouth, NeighboursTouchWithinATenthOfAMillimetreAndDoNotIntersect) {
    for (const int quadrant : {10, 30}) {
        for (int place = 2; place <= 8; ++place) {
            const double gap = between(placed(mouth(), quadrant + place - 1), placed(mouth(), quadrant + place));
            EXPECT_GT(gap, 0.01) << quadrant + place;
            EXPECT_LT(gap, 0.1) << quadrant + place;
        }
    }
    for (const auto& [right, left] : {std::pair(11, 21), std::pair(41, 31)}) {
        const double gap = between(placed(mouth(), right), placed(mouth(), left));
        EXPECT_GT(gap, 0.01) << right;
        EXPECT_LT(gap, 0.15) << right;
    }
}

TEST(BuiltinMouth, BackTeethBiteOnTheirOpponentsAndNoneCutsIntoThem) {
    for (int place = 1; place <= 8; ++place) {
        double least = 1;
        for (int crossingFace = std::max(1, place - 2); crossingFace <= std::min(8, place + 2); ++crossingFace) {
            least = std::min(least, between(placed(mouth(), 10 + place), placed(mouth(), 40 + crossingFace)));
        }
        EXPECT_GT(least, 0.01) << place;
        if (place > 3) {
            EXPECT_LT(least, 0.25) << place;
        }
    }
}

TEST(BuiltinMouth, UpperTeethOverlapTheLowerOnesToTheOutside) {
    const Box3 upper = boundingBox(placed(mouth(), 11)), lower = boundingBox(placed(mouth(), 41));
    EXPECT_GT(upper.max().y(), lower.max().y() + 1);  // overjet
    EXPECT_LT(upper.min().z(), lower.max().z() - 1);  // overbite
    EXPECT_GT(upper.min().z(), lower.max().z() - 4);
    EXPECT_GT(boundingBox(placed(mouth(), 16)).max().x(), boundingBox(placed(mouth(), 46)).max().x());
}

TEST(BuiltinMouth, ArchesAreAsWideAsAveragePeoples) {
    const auto across = [&](int right) {
        const MouthTooth* tooth = mouth().find(right);
        const std::vector<Vec3f>& vertices = tooth->tooth.outer.vertices;
        const auto tip = std::ranges::max_element(vertices, {}, [](const Vec3f& v) { return v.z(); });
        const bool hasTip = tooth->tooth.fdi % 10 == 3;
        return 2 * (tooth->toothInMouth * (hasTip ? tip->cast<double>() : Vec3(0, 0, 6))).x();
    };
    EXPECT_NEAR(across(13), 35, 3.5);  // tips of the upper canines
    EXPECT_NEAR(across(43), 26, 3);
    EXPECT_NEAR(across(16), 48, 4);  // middle of the first molars
    EXPECT_NEAR(across(46), 43, 4);
}

TEST(BuiltinMouth, GumsAreClosedBodiesWithoutHolesThatDoNotIntersectThemselves) {
    for (const TriangleMesh* gingiva : {&mouth().upperGingiva, &mouth().lowerGingiva}) {
        const MeshReport report = reportOn(*gingiva);
        EXPECT_TRUE(report.watertight());
        EXPECT_EQ(report.shells.size(), 1u);
        EXPECT_GT(report.signedVolume, 10000);
        EXPECT_FALSE(test::selfIntersects(*gingiva));
    }
}

TEST(BuiltinMouth, NoGumStandsBetweenTheTeethAboveTheirContacts) {
    const SurfacePart upper(mouth().upperGingiva), lower(mouth().lowerGingiva);
    const ToothArrangement places = arrangeTeeth(0);
    for (const JawQuadrant* side : {&places.upper, &places.lower}) {
        const SurfacePart& gingiva = side->upper ? upper : lower;
        const Vec3 crownward = (side->upper ? -1 : 1) * Vec3::UnitZ();
        for (std::size_t i = 0; i < kTeethPerQuadrant; ++i) {
            const Vec3& contact = side->contacts[i].point;
            const Vec3 across = places.line.at(places.line.of(contact.x(), contact.y()).s).outward;
            for (double out = -5; out <= 5; out += 0.25) {
                for (double above = -0.5; above < 3; above += 0.25) {
                    EXPECT_FALSE(contains(gingiva, contact + out * across + above * crownward)) << i << " " << out;
                }
            }
        }
    }
}

TEST(BuiltinMouth, GumsKeepClearOfTheTeethAndCoverTheirNecks) {
    const SurfacePart gingiva(mouth().lowerGingiva);
    for (const int fdi : {41, 43, 44, 46}) {
        const MouthTooth* tooth = mouth().find(fdi);
        const TriangleMesh outer = placed(mouth(), fdi);
        for (std::size_t i = 0; i < outer.vertices.size(); i += 3) {
            ASSERT_FALSE(contains(gingiva, outer.vertices[i].cast<double>())) << fdi;
        }
        for (const double side : {-1.0, 1.0}) {  // just outside the root, a little below the cervical line
            double y = 0;
            const SurfacePart root(tooth->tooth.outer);
            while (contains(root, Vec3(0, y, -2))) y += 0.05 * side;
            EXPECT_TRUE(contains(gingiva, tooth->toothInMouth * Vec3(0, y + 0.6 * side, -2))) << fdi << " " << side;
            EXPECT_FALSE(contains(gingiva, tooth->toothInMouth * Vec3(0, y + 0.6 * side, 4))) << fdi << " " << side;
        }
    }
}

TEST(BuiltinMouth, DrawnGumsReachALittleIntoEachToothAndHaveAllZones) {
    for (const bool upper : {true, false}) {
        const ZonedMesh& gum = upper ? mouth().upperShown : mouth().lowerShown;
        ASSERT_EQ(gum.zones.size(), gum.mesh.vertices.size());
        const auto has = [&](int from, int to) {
            return std::ranges::any_of(gum.zones, [&](std::uint8_t zone) { return zone >= from && zone <= to; });
        };
        EXPECT_TRUE(has(0, 10) && has(ZonedMesh::kSecond - 5, ZonedMesh::kSecond + 5));
        EXPECT_TRUE(has(ZonedMesh::kThird - 2, ZonedMesh::kThird));
        EXPECT_FALSE(has(ZonedMesh::kThird + 1, 255));
        for (const int fdi : upper ? std::array{11, 13, 14, 16} : std::array{41, 43, 44, 46}) {
            const SurfacePart tooth(placed(mouth(), fdi));
            int inside = 0;
            double deepest = 0;
            for (const Vec3f& vertex : gum.mesh.vertices) {
                const Vec3 point = vertex.cast<double>();
                if (!tooth.tree().box().contains(point) || !contains(tooth, point)) continue;
                ++inside;
                deepest = std::max(deepest, closestPoint(tooth, point)->distance);
            }
            EXPECT_GT(inside, 50) << fdi << ": no dark gap is left around it";
            EXPECT_LT(deepest, 1.2) << fdi << ": it is not seen where the tooth was cut";
        }
    }
}

/// Height of the margin of the upper gingiva, along a vertical line through any of `ys` at `x`.
double marginOf(const SurfacePart& gingiva, double x, double fromY, double toY) {
    for (double z = -4; z < 15; z += 0.05) {
        for (double y = fromY; y < toY; y += 0.1) {
            if (contains(gingiva, Vec3(x, y, z))) return z;
        }
    }
    return 15;
}

TEST(BuiltinMouth, PapillaeReachFartherDownThanTheMarginsBesideThem) {
    const SurfacePart gingiva(mouth().upperGingiva);
    const double middle = boundingBox(placed(mouth(), 11)).center().x();
    const double papilla = marginOf(gingiva, 0, -6, 3), margin = marginOf(gingiva, middle, -1, 5);
    EXPECT_GT(margin - papilla, 1.2);
    EXPECT_LT(margin - papilla, 4.5);
}

/// Where the face of the gingiva is between the two central incisors at a height; nothing above the papilla.
std::optional<double> faceBetweenIncisors(const SurfacePart& gingiva, double z) {
    constexpr double kFront = 6, kBehind = -6, kStep = 0.02;
    for (double y = kFront; y > kBehind; y -= kStep) {
        if (contains(gingiva, Vec3(0, y, z))) return y;
    }
    return std::nullopt;
}

TEST(BuiltinMouth, TheFaceOfADrawnPapillaHasNoLedge) {
    for (const bool upper : {true, false}) {
        const SurfacePart gingiva((upper ? mouth().upperShown : mouth().lowerShown).mesh);
        const double crownward = upper ? -1 : 1;
        constexpr double kStep = 0.1, kFromTip = 0.5, kFar = 4.5;  // mm
        double tip = -12;
        for (double height = -12; height < 6; height += kStep) {
            if (faceBetweenIncisors(gingiva, crownward * height)) tip = height;
        }
        for (double below = kFromTip; below < kFar; below += kStep) {
            const auto face = faceBetweenIncisors(gingiva, crownward * (tip - below));
            const auto under = faceBetweenIncisors(gingiva, crownward * (tip - below - kStep));
            ASSERT_TRUE(face && under) << upper << " " << below;
            EXPECT_LT(*under - *face, 1.5 * kStep) << upper << " at " << below << " mm below the tip of the papilla";
        }
    }
}

TEST(BuiltinMouth, MissingTeethLeaveAHealedPlace) {
    const BuiltinMouth gap = *makeMouth({.triangles = 2000, .missing = test::allTeethExcept({36, 45, 47})});
    EXPECT_EQ(gap.teeth.size(), 3u);
    EXPECT_EQ(gap.find(46), nullptr);
    EXPECT_NE(gap.find(36), nullptr);
    const SurfacePart healed(gap.lowerGingiva);
    const MouthTooth* lost = mouth().find(46);
    EXPECT_TRUE(contains(healed, lost->toothInMouth * Vec3(0, 0, -3)));
    EXPECT_FALSE(contains(healed, lost->toothInMouth * Vec3(0, 0, 5)));
    EXPECT_TRUE(reportOn(gap.lowerGingiva).watertight());
}

TEST(BuiltinMouth, TheOpenJawParts40MillimetresAtTheIncisors) {
    BuiltinMouth open;
    open.teeth = mouth().teeth;
    open.lowerJaw = lowerJawPose(JawPose::Open);
    const double upper = boundingBox(placed(open, 11)).min().z(), lower = boundingBox(placed(open, 41)).max().z();
    EXPECT_NEAR(upper - lower, 40, 2.5);
    EXPECT_GT(between(placed(open, 18), placed(open, 48)), 0.9);
}

TEST(BuiltinMouth, TheSameRequestGivesTheSameBits) {
    const MouthLayout again = *makeMouthLayout({.triangles = kTriangles, .missing = {}});
    EXPECT_TRUE(test::areBitEqual(again.upperGingiva, mouth().upperGingiva));
    EXPECT_TRUE(test::areBitEqual(makeTooth({26, kTriangles, 0, {}}).outer, mouth().find(26)->tooth.outer));
    EXPECT_EQ(again.toothInMouth[5].position, mouth().find(16)->toothInMouth.position);
}

TEST(BuiltinMouth, ToothOfTheOtherSideIsTheToothThatIsMadeThere) {
    const BuiltinTooth right = makeTooth({16, 3000, 5, {}}), left = makeTooth({26, 3000, 5, {}});
    const BuiltinTooth other = contralateral(right);
    EXPECT_EQ(other.fdi, 26);
    EXPECT_EQ(other.name, left.name);
    EXPECT_TRUE(test::areBitEqual(other.outer, left.outer));
    EXPECT_TRUE(test::areBitEqual(other.pulp, left.pulp));
}

}  // namespace
}  // namespace tactooth
