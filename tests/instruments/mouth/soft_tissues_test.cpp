// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/mouth/soft_tissues.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/mesh/mesh_report.h"
#include "instruments/builtin_mouth.h"
#include "instruments/mouth/tooth_arrangement.h"

namespace tactooth {
namespace {

constexpr std::size_t kTissues = 6;  // two cheeks

/// The poses of all teeth of one side, as makeMouthLayout gives them.
std::vector<Pose> sideOf(const ToothArrangement& places) {
    std::vector<Pose> side;
    for (const JawQuadrant* quadrant : {&places.upper, &places.lower}) {
        for (const PlacedShape& tooth : quadrant->teeth) side.push_back(tooth.shapeInMouth);
    }
    return side;
}

const ToothArrangement& teeth() {
    static const ToothArrangement made = arrangeTeeth(0);
    return made;
}

std::vector<SoftTissue> tissuesFor(int worked) {
    return makeSoftTissues(sideOf(teeth()), lowerJawPose(JawPose::Open), worked);
}
const std::vector<SoftTissue>& tissues() {
    static const std::vector<SoftTissue> made = tissuesFor(0);
    return made;
}
const ZonedMesh& tissue(SoftTissueKind kind) { return std::ranges::find(tissues(), kind, &SoftTissue::kind)->shown; }

Vec3 normalOf(const TriangleMesh& mesh, std::size_t triangle) {
    const Vec3 a = mesh.corner(triangle, 0);
    return (mesh.corner(triangle, 1) - a).cross(mesh.corner(triangle, 2) - a);
}

/// Distance of a place from the teeth of the lower jaw, by their own fields; positive outside all of them. About exact
/// near the crowns.
double awayFromLowerTeeth(const Vec3& place) {
    const Pose mouthInJaw = lowerJawPose(JawPose::Open).inverse();
    const Vec3 inJaw = mouthInJaw * place;
    double nearest = 100;
    for (const PlacedShape& tooth : teeth().lower.teeth) {
        const Pose mouthInShape = tooth.shapeInMouth.inverse();
        for (const double side : {-1.0, 1.0})
            nearest = std::min(nearest, tooth.shape.outer(mouthInShape * Vec3(side * inJaw.x(), inJaw.y(), inJaw.z())));
    }
    return nearest;
}

TEST(SoftTissues, EachIsOneOrientedSurface) {
    ASSERT_EQ(tissues().size(), kTissues);
    for (const auto& [kind, shown] : tissues()) {
        const bool isClosed = kind == SoftTissueKind::Tongue || kind == SoftTissueKind::Ring;
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        for (const Triangle& t : shown.mesh.triangles) {
            for (int corner = 0; corner < 3; ++corner) ++edges[{t[corner], t[(corner + 1) % 3]}];
        }
        int open = 0, twice = 0;
        for (const auto& [edge, count] : edges) {
            twice += count > 1;
            open += !edges.contains({edge.second, edge.first});
        }
        EXPECT_EQ(twice, 0) << static_cast<int>(kind);
        EXPECT_EQ(open == 0, isClosed) << static_cast<int>(kind);
        EXPECT_EQ(shown.zones.size(), shown.mesh.vertices.size());
        EXPECT_LT(shown.mesh.triangles.size(), 30000U) << static_cast<int>(kind);
        EXPECT_TRUE(std::ranges::all_of(shown.mesh.vertices, [](const Vec3f& vertex) { return vertex.allFinite(); }));
    }
}

TEST(SoftTissues, BothSidesAreMirrorImages) {
    for (const auto& [kind, shown] : tissues()) {
        if (kind == SoftTissueKind::Cheek) continue;
        const Box3 box = boundingBox(shown.mesh);
        EXPECT_NEAR(box.min().x(), -box.max().x(), 0.05) << static_cast<int>(kind);
    }
    const Box3 right = boundingBox(tissues()[1].shown.mesh), left = boundingBox(tissues()[2].shown.mesh);
    EXPECT_NEAR(right.min().x(), 0, 1e-4);
    EXPECT_NEAR(left.max().x(), 0, 1e-4);
    EXPECT_NEAR(right.max().x(), -left.min().x(), 1e-4);
}

TEST(SoftTissues, TheTongueLeavesRoomForTheCrowns) {
    const ZonedMesh& tongue = tissue(SoftTissueKind::Tongue);
    double nearest = 100;
    int back = 0;
    for (std::size_t i = 0; i < tongue.mesh.vertices.size(); ++i) {
        if (tongue.zones[i] < ZonedMesh::kSecond) continue;  // the floor of the mouth reaches the gum
        nearest = std::min(nearest, awayFromLowerTeeth(tongue.mesh.vertices[i].cast<double>()));
        back += tongue.zones[i] == ZonedMesh::kThird;
    }
    EXPECT_GT(nearest, 0.8);
    EXPECT_LT(nearest, 5) << "it lies between the teeth";
    EXPECT_GT(back, 1000);
}

/// The distance from the lingual side of a lower tooth to the tongue, at the height of the tongue's back.
double roomBeside(const std::vector<SoftTissue>& made, int fdi) {
    const ZonedMesh& tongue = made.front().shown;
    const PlacedShape& tooth = teeth().lower.teeth[static_cast<std::size_t>(fdi % 10 - 1)];
    Vec3 neck = tooth.shapeInMouth.position;
    neck.x() = fdi / 10 == 4 ? std::abs(neck.x()) : -std::abs(neck.x());
    const Vec3 inMouth = lowerJawPose(JawPose::Open) * neck;
    double nearest = 100;
    for (std::size_t i = 0; i < tongue.mesh.vertices.size(); ++i) {
        if (tongue.zones[i] < ZonedMesh::kThird) continue;
        nearest = std::min(nearest, (tongue.mesh.vertices[i].cast<double>() - inMouth).norm());
    }
    return nearest;
}

TEST(SoftTissues, TheTongueIsHeldAsideAtTheToothThatIsWorkedOn) {
    constexpr double kMirror = 22;  // mm: its head, which stands beside the tooth
    for (const int fdi : {46, 36, 44, 41}) {
        const std::vector<SoftTissue> held = tissuesFor(fdi);
        EXPECT_LT(roomBeside(tissues(), fdi), kMirror - 5) << fdi;
        EXPECT_GT(roomBeside(held, fdi), kMirror - 1) << fdi;
    }
    EXPECT_NEAR(roomBeside(tissuesFor(46), 36), roomBeside(tissues(), 36), 1.0) << "it stays on the other side";
    EXPECT_EQ(tissuesFor(16).front().shown.mesh.vertices, tissues().front().shown.mesh.vertices)
        << "the upper teeth are far from it";
}

TEST(SoftTissues, TheTongueIsSmooth) {
    for (const int fdi : {0, 46, 33, 41}) {
        const ZonedMesh shown = tissuesFor(fdi).front().shown;
        const TriangleMesh& tongue = shown.mesh;
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> sides;
        for (std::size_t t = 0; t < tongue.triangles.size(); ++t) {
            const Triangle& triangle = tongue.triangles[t];
            for (int corner = 0; corner < 3; ++corner) sides[{triangle[corner], triangle[(corner + 1) % 3]}] = t;
        }
        double sharpest = 1;  // cosine
        for (const auto& [edge, t] : sides) {
            if (shown.zones[edge.first] < ZonedMesh::kSecond) continue;  // the frenulum in the floor is a fold
            const Vec3 place = tongue.vertices[edge.first].cast<double>();
            const std::size_t other = sides.at({edge.second, edge.first});
            const Vec3 one = normalOf(tongue, t).normalized(), next = normalOf(tongue, other).normalized();
            const Vec3 up = lowerJawPose(JawPose::Open).rotation * Vec3::UnitZ();
            if (one.dot(up) < 0.3 || next.dot(up) < 0.3) continue;  // the far side of the body has sharp edges
            sharpest = std::min(sharpest, one.dot(next));
            EXPECT_GT(one.dot(next), 0.75) << fdi << " at " << place.transpose();
        }
        EXPECT_LT(sharpest, 0.999);
    }
}

/// Seen from outside, open surfaces must not hide the teeth: their front faces point into the mouth.
TEST(SoftTissues, CheeksFaceTheTeeth) {
    const TriangleMesh& cheeks = tissue(SoftTissueKind::Cheek).mesh;  // the right one
    double inward = 0, outward = 0;
    for (std::size_t t = 0; t < cheeks.triangles.size(); ++t) {
        const Vec3 middle = (cheeks.corner(t, 0) + cheeks.corner(t, 1) + cheeks.corner(t, 2)) / 3;
        if (middle.x() < 34) continue;  // the vestibules have two sides
        const double facing = -normalOf(cheeks, t).x();
        (facing > 0 ? inward : outward) += std::abs(facing);
    }
    EXPECT_GT(inward, 200);  // twice the area, mm2
    EXPECT_LT(outward, 0.02 * inward);
}

TEST(SoftTissues, LipsAreOpenAroundTheTeeth) {
    const Pose jaw = lowerJawPose(JawPose::Open);
    const Box3 opening = boundingBox(tissue(SoftTissueKind::Ring).mesh);
    for (const PlacedShape& tooth : teeth().upper.teeth) {
        const Vec3 edge = tooth.shapeInMouth * Vec3(0, 0, tooth.shape.bounds.max().z());
        EXPECT_LT(edge.z(), opening.max().z() - 5) << "the crown is in sight from the front";
    }
    for (const PlacedShape& tooth : teeth().lower.teeth) {
        const Vec3 edge = jaw * (tooth.shapeInMouth * Vec3(0, 0, tooth.shape.bounds.max().z()));
        EXPECT_GT(edge.z(), opening.min().z() + 5);
    }
    const TriangleMesh& lips = tissue(SoftTissueKind::Lips).mesh;
    double forward = 0, back = 0;
    for (std::size_t t = 0; t < lips.triangles.size(); ++t) {
        const double facing = normalOf(lips, t).y();
        (facing > 0 ? forward : back) += std::abs(facing);
    }
    EXPECT_GT(forward, 5 * back) << "the skin faces forward";
}

TEST(SoftTissues, NoTissueBelongsToAClosedMouth) {
    BuiltinMouth mouth;
    mouth.sideInMouth = sideOf(teeth());
    EXPECT_TRUE(softTissuesOf(mouth).empty());
    mouth.jaw = JawPose::Open;
    mouth.lowerJaw = lowerJawPose(JawPose::Open);
    EXPECT_EQ(softTissuesOf(mouth, 46).size(), kTissues);
}

TEST(SoftTissues, AreTheSameEachTime) {
    const std::vector<SoftTissue> again = tissuesFor(0);
    for (std::size_t i = 0; i < again.size(); ++i) {
        EXPECT_EQ(again[i].shown.mesh.vertices, tissues()[i].shown.mesh.vertices);
        EXPECT_EQ(again[i].shown.zones, tissues()[i].shown.zones);
    }
}

TEST(SoftTissues, FitOtherPatients) {
    for (const std::uint32_t seed : {3U, 7U}) {
        const ToothArrangement places = arrangeTeeth(seed);
        for (const auto& [kind, shown] : makeSoftTissues(sideOf(places), lowerJawPose(JawPose::Open), 46)) {
            EXPECT_GT(shown.mesh.triangles.size(), 1000U) << seed;
            EXPECT_TRUE(
                std::ranges::all_of(shown.mesh.vertices, [](const Vec3f& vertex) { return vertex.allFinite(); }));
        }
    }
}

}  // namespace
}  // namespace tactooth
