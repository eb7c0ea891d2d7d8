// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/builtin_tooth.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <span>

#include "collision/bvh/closest_point.h"
#include "instruments/mesh_checks.h"
#include "support/materials.h"
#include "support/mesh_checks.h"
#include "support/sanitizer.h"

namespace tactooth {
namespace {

using enum BuiltinToothKind;

/// Wheeler's average tooth, mm. Cervix: mesiodistal width between the proximal tops of the cervical line, which lie
/// `mesialRise` and `distalRise` above its buccal and lingual parts.
struct Average {
    BuiltinToothKind kind;
    int fdi;
    double crown, root, mesiodistal, faciolingual, cervixMesiodistal, cervixFaciolingual, mesialRise, distalRise;
};

constexpr Average kAverages[] = {{LowerFirstMolar, 46, 7.5, 14.0, 11.0, 10.5, 9.0, 9.0, 1.0, 0.0},
                                 {UpperCentralIncisor, 11, 10.5, 13.0, 8.5, 7.0, 7.0, 6.0, 3.5, 2.5},
                                 {UpperCanine, 13, 10.0, 17.0, 7.5, 8.0, 5.5, 7.0, 2.5, 1.5}};

constexpr std::span<const Average> kTestedAverages = std::span(kAverages).first(test::cases<std::size_t>(3, 1));

constexpr double kTolerance = 0.03;  // of each length

const BuiltinTooth& toothOf(BuiltinToothKind kind) {
    static std::map<BuiltinToothKind, BuiltinTooth> made;
    const auto [place, isNew] = made.try_emplace(kind);
    if (isNew) place->second = makeBuiltinTooth(kind);
    return place->second;
}

std::array<const TriangleMesh*, 5> meshesOf(const BuiltinTooth& tooth) {
    return {&tooth.outer, &tooth.enamel, &tooth.dentin, &tooth.pulp, &tooth.caries};
}

/// Extent of the vertices within 0.15 mm of a height.
Box3 sliceAt(const TriangleMesh& mesh, double z) {
    Box3 box;
    for (const Vec3f& vertex : mesh.vertices) {
        if (std::abs(vertex.z() - z) < 0.15) box.extend(vertex.cast<double>());
    }
    return box;
}

bool isInside(const TriangleMesh& mesh, const Vec3& point) { return test::windingNumber(mesh, point) > 0.5; }

class EveryTooth : public testing::TestWithParam<Average> {
protected:
    const Average& average_ = GetParam();
    const BuiltinTooth& tooth_ = toothOf(GetParam().kind);
};

TEST_P(EveryTooth, LayersAreClosedAndFaceOutward) {
    for (const TriangleMesh* layer : meshesOf(tooth_)) {
        EXPECT_EQ(test::unpairedEdges(*layer), 0);
        EXPECT_GT(test::volumeOf(*layer), 1.0);
    }
}

TEST_P(EveryTooth, LayersAreOnePieceWithoutHandles) {
    for (const TriangleMesh* layer : meshesOf(tooth_)) {
        const auto vertices = static_cast<int>(layer->vertices.size());
        EXPECT_EQ(vertices - static_cast<int>(layer->triangles.size()) / 2, 2);
    }
}

TEST_P(EveryTooth, LayersDoNotIntersectThemselves) {
    for (const TriangleMesh* layer : meshesOf(tooth_)) EXPECT_FALSE(test::selfIntersects(*layer));
}

TEST_P(EveryTooth, LayersDoNotIntersectThemselvesAtOtherResolutions) {
    for (const int triangles : {6000, 13000, 35000}) {
        const BuiltinTooth tooth = makeBuiltinTooth(average_.kind, triangles);
        for (const TriangleMesh* layer : meshesOf(tooth)) EXPECT_FALSE(test::selfIntersects(*layer)) << triangles;
    }
}

TEST_P(EveryTooth, HasTheLengthsOfTheAverageTooth) {
    const Box3 box = boundingBox(tooth_.outer);
    EXPECT_EQ(tooth_.fdi, average_.fdi);
    EXPECT_NEAR(box.max().z(), average_.crown, kTolerance * average_.crown);
    EXPECT_NEAR(-box.min().z(), average_.root, kTolerance * average_.root);
}

TEST_P(EveryTooth, HasTheCrownDiametersOfTheAverageTooth) {
    const Vec3 size = boundingBox(tooth_.outer).sizes();
    EXPECT_NEAR(size.x(), average_.mesiodistal, kTolerance * average_.mesiodistal);
    EXPECT_NEAR(size.y(), average_.faciolingual, kTolerance * average_.faciolingual);
}

TEST_P(EveryTooth, HasTheCervicalDiametersOfTheAverageTooth) {
    const Box3 mesial = sliceAt(tooth_.outer, average_.mesialRise);
    const Box3 distal = sliceAt(tooth_.outer, average_.distalRise);
    const bool mesialIsPlus = mesialX(tooth_.fdi) > 0;
    const double width = mesialIsPlus ? mesial.max().x() - distal.min().x() : distal.max().x() - mesial.min().x();
    EXPECT_NEAR(width, average_.cervixMesiodistal, kTolerance * average_.cervixMesiodistal);
    EXPECT_NEAR(sliceAt(tooth_.outer, 0).sizes().y(), average_.cervixFaciolingual,
                kTolerance * average_.cervixFaciolingual);
}

TEST_P(EveryTooth, HasAboutAsManyTrianglesAsAskedFor) {
    EXPECT_NEAR(static_cast<double>(tooth_.outer.triangles.size()), 20000, 2000);
    const auto coarse = static_cast<double>(makeBuiltinTooth(average_.kind, 8000, 0).outer.triangles.size());
    EXPECT_NEAR(coarse, 8000, 1200);
}

TEST_P(EveryTooth, PulpLiesWithinTheDentin) {
    for (std::size_t i = 0; i < tooth_.pulp.vertices.size(); i += 97) {
        EXPECT_TRUE(isInside(tooth_.dentin, tooth_.pulp.vertices[i].cast<double>())) << "vertex " << i;
    }
}

TEST_P(EveryTooth, DentinOfTheCrownLiesWithinTheTooth) {
    for (std::size_t i = 0; i < tooth_.dentin.vertices.size(); i += 53) {
        const Vec3 vertex = tooth_.dentin.vertices[i].cast<double>();
        if (vertex.z() < average_.mesialRise + 0.7) continue;
        EXPECT_TRUE(isInside(tooth_.outer, vertex)) << "vertex " << i;
    }
}

TEST_P(EveryTooth, DentinSharesItsRootSurfaceWithTheTooth) {
    std::set<std::array<float, 3>> known;
    for (const Vec3f& v : tooth_.outer.vertices) known.insert({v.x(), v.y(), v.z()});
    int shared = 0;
    for (const Vec3f& v : tooth_.dentin.vertices) {
        if (v.z() > -2) continue;
        EXPECT_TRUE((known.contains({v.x(), v.y(), v.z()})));
        ++shared;
    }
    EXPECT_GT(shared, 1000);
}

TEST_P(EveryTooth, EnamelAndDentinTogetherFillTheTooth) {
    const Box3 box = boundingBox(tooth_.outer);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    int inside = 0;
    for (int i = 0; i < 250; ++i) {
        const Vec3 part(unit(random), unit(random), unit(random));
        const Vec3 point = box.min() + part.cwiseProduct(box.sizes());
        const bool filled = isInside(tooth_.enamel, point) || isInside(tooth_.dentin, point);
        EXPECT_EQ(filled, isInside(tooth_.outer, point)) << point.transpose();
        inside += filled;
    }
    EXPECT_GT(inside, 50);
    EXPECT_LT(inside, 200);
}

/// Smallest distance from a point to the vertices of a mesh: good to a part of the edge length.
double distanceToVertices(const TriangleMesh& mesh, const Vec3& point) {
    double nearest = 1e9;
    for (const Vec3f& vertex : mesh.vertices) nearest = std::min(nearest, (vertex.cast<double>() - point).norm());
    return nearest;
}

TEST_P(EveryTooth, EnamelThinsFromTheTopOfTheCrownToAFeatherEdge) {
    const auto top = std::ranges::max_element(tooth_.outer.vertices, {}, [](const Vec3f& v) { return v.z(); });
    const double atTop = distanceToVertices(tooth_.dentin, top->cast<double>());
    EXPECT_GT(atTop, 1.2);
    EXPECT_LT(atTop, 3.0);
    for (const Vec3f& vertex : tooth_.outer.vertices) {
        const bool atBuccalNeck = std::abs(vertex.x()) < 0.3 && vertex.y() > 2 && vertex.z() > 0.1 && vertex.z() < 0.4;
        if (!atBuccalNeck) continue;
        EXPECT_LT(distanceToVertices(tooth_.dentin, vertex.cast<double>()), 0.4);
    }
}

TEST_P(EveryTooth, LesionReachesFromTheSurfaceIntoTheDentinButNotThePulp) {
    int atSurface = 0, inDentin = 0;
    for (std::size_t i = 0; i < tooth_.caries.vertices.size(); i += 7) {
        const Vec3 vertex = tooth_.caries.vertices[i].cast<double>();
        if (distanceToVertices(tooth_.outer, vertex) < 0.15) ++atSurface;
        if (isInside(tooth_.dentin, vertex)) ++inDentin;
    }
    EXPECT_GT(atSurface, 3);
    EXPECT_GT(inDentin, 20);
    for (std::size_t i = 0; i < tooth_.pulp.vertices.size(); i += 31) {
        EXPECT_FALSE(isInside(tooth_.caries, tooth_.pulp.vertices[i].cast<double>()));
    }
}

TEST_P(EveryTooth, IsALayeredToothWithEnamelAboveTheCervicalLineAndDentinBelow) {
    const auto layered = LayeredTooth::make(tooth_.outer, layersOf(tooth_));
    ASSERT_TRUE(layered.has_value()) << layered.error().message();
    EXPECT_EQ(layered->layers().size(), 4u);
    const SurfacePart& outer = *layered->outer();
    int enamel = 0, dentin = 0;
    for (std::uint32_t i = 0; i < tooth_.outer.triangles.size(); ++i) {
        const double z = tooth_.outer.corner(i, 0).z();
        const auto tag = static_cast<MaterialId>(outer.tag(i));
        if (z < -0.5) {
            EXPECT_EQ(tag, test::kDentin);
            ++dentin;
        } else if (z > average_.mesialRise + 1.0 && tag != test::kCaries) {
            EXPECT_EQ(tag, test::kEnamel);
            ++enamel;
        }
    }
    EXPECT_GT(enamel, 4000);
    EXPECT_GT(dentin, 4000);
}

INSTANTIATE_TEST_SUITE_P(Builtin, EveryTooth, testing::ValuesIn(kTestedAverages.begin(), kTestedAverages.end()),
                         [](const auto& instance) { return "Fdi" + std::to_string(instance.param.fdi); });

TEST(BuiltinTooth, LesionGrowsWithItsWidthAndZeroMeansSound) {
    const BuiltinTooth small = makeBuiltinTooth(LowerFirstMolar, 8000, 1.2);
    const BuiltinTooth large = makeBuiltinTooth(LowerFirstMolar, 8000, 3.0);
    EXPECT_GT(test::volumeOf(large.caries), 4 * test::volumeOf(small.caries));
    EXPECT_TRUE(makeBuiltinTooth(LowerFirstMolar, 8000, 0).caries.empty());
}

/// On teeth of both sides of the mouth, whose frames are mirror images.
TEST(BuiltinTooth, DecayBeginsWhereItIsPlaced) {
    std::mt19937 random(5);
    for (const int fdi : {36, 46, 11}) {
        const BuiltinTooth sound = makeTooth({.fdi = fdi});
        std::vector<Vec3> crown;
        for (const Vec3f& vertex : sound.outer.vertices) {
            if (vertex.z() > 1.5F && vertex.z() < 5) crown.push_back(vertex.cast<double>());
        }
        for (int i = 0; i < test::cases(3, 1); ++i) {
            const Vec3 place = crown[std::uniform_int_distribution<std::size_t>(0, crown.size() - 1)(random)];
            const Lesion lesion{.site = LesionSite::Usual, .width = 1.6, .depth = 1.2, .place = place};
            const BuiltinTooth decayed = makeTooth({.fdi = fdi, .lesion = lesion});
            ASSERT_FALSE(decayed.caries.empty());
            double nearest = 100, farthest = 0;
            for (const Vec3f& vertex : decayed.caries.vertices) {
                const double distance = (vertex.cast<double>() - place).norm();
                nearest = std::min(nearest, distance);
                farthest = std::max(farthest, distance);
            }
            EXPECT_LT(nearest, 0.2) << fdi;
            EXPECT_LT(farthest, 1.7) << fdi;
            EXPECT_GT(farthest, 0.7) << fdi;
        }
    }
}

/// Places on the buccal side of the crown, from mesial to distal.
std::vector<Vec3> buccalPlaces(const BuiltinTooth& tooth) {
    std::vector<Vec3> places;
    for (const double x : {-1.5, 0.0, 1.5}) {
        Vec3 found(x, 0, 2);
        for (const Vec3f& vertex : tooth.outer.vertices) {
            const Vec3 place = vertex.cast<double>();
            const bool isThere = std::abs(place.x() - x) < 0.3 && std::abs(place.z() - 2) < 0.3;
            if (isThere && place.y() > found.y()) found = place;
        }
        places.push_back(found);
    }
    return places;
}

TEST(BuiltinTooth, PaintedDecayIsOneClosedBodyWithEachOfItsPlaces) {
    for (const int fdi : {46, 36}) {
        const std::vector<Vec3> places = buccalPlaces(makeTooth({.fdi = fdi, .triangles = 8000}));
        Lesion lesion{.width = 1.6, .depth = 1.2, .place = places[0]};
        const double one = test::volumeOf(makeTooth({.fdi = fdi, .triangles = 8000, .lesion = lesion}).caries);
        lesion.spread = {places[1], places[2]};
        const BuiltinTooth painted = makeTooth({.fdi = fdi, .triangles = 8000, .lesion = lesion});
        EXPECT_EQ(test::openEdges(painted.caries), 0) << fdi;
        EXPECT_GT(test::volumeOf(painted.caries), 2.2 * one) << fdi;
        EXPECT_LT(test::volumeOf(painted.caries), 3.2 * one) << fdi;
        for (const Vec3& place : places) {
            const Vec3 inward(0, -0.4, 0);
            EXPECT_TRUE(isInside(painted.caries, place + inward)) << fdi << ' ' << place.transpose();
        }
        lesion.place = lesion.spread[0];
        lesion.spread = {places[0], places[2]};
        const BuiltinTooth reordered = makeTooth({.fdi = fdi, .triangles = 8000, .lesion = lesion});
        EXPECT_NEAR(test::volumeOf(reordered.caries), test::volumeOf(painted.caries), 0.01 * one) << fdi;
    }
}

TEST(BuiltinTooth, ARimLiesAroundTheDecayInTheDentinAlone) {
    Lesion lesion{.site = LesionSite::Occlusal, .width = 2, .depth = 2.2};
    lesion.rim = LesionRim{.width = 0.6, .material = test::kRestoration};
    const ToothRequest request{.fdi = 46, .triangles = 8000, .lesion = lesion};
    const BuiltinTooth tooth = makeTooth(request);
    EXPECT_EQ(test::openEdges(tooth.rim), 0);
    EXPECT_EQ(tooth.rimMaterial, test::kRestoration);
    ASSERT_GT(tooth.rim.vertices.size(), 500U);
    const SurfacePart dentin(tooth.dentin, {}, 0), caries(tooth.caries, {}, 0);
    double outside = 0, farthest = 0;  // mm
    for (const Vec3f& each : tooth.rim.vertices) {
        const Vec3 vertex = each.cast<double>();
        const auto distanceTo = [&](const SurfacePart& part) {
            return (closestPoint(part, vertex)->point - vertex).norm();
        };
        if (!isInside(tooth.dentin, vertex)) outside = std::max(outside, distanceTo(dentin));
        if (!isInside(tooth.caries, vertex)) farthest = std::max(farthest, distanceTo(caries));
    }
    EXPECT_LT(outside, 0.1);
    EXPECT_NEAR(farthest, 0.6, 0.1);
    const Expected<LayeredTooth> layered = layeredTooth(tooth);
    ASSERT_TRUE(layered) << layered.error().message();
    ASSERT_EQ(layered->layers().size(), 5U);

    ToothRequest wider = request;
    wider.lesion->rim->width = 0.9;
    EXPECT_NE(toothFingerprint(wider), toothFingerprint(request));
    wider.lesion->rim.reset();
    EXPECT_NE(toothFingerprint(wider), toothFingerprint(request));
    EXPECT_TRUE(makeTooth(wider).rim.empty());
}

TEST(BuiltinTooth, PulpChamberLiesWhereItIsMeasured) {
    // A. S. Deutsch, B. L. Musikant 2004, lower molars: chamber ceiling 6.36 +- 0.93 mm and floor 7.95 +- 0.79 mm below
    // the cusp, measured in the chamber's middle.
    const BuiltinTooth& molar = toothOf(LowerFirstMolar);
    Box3 middle;
    for (const Vec3f& v : molar.pulp.vertices) {
        if (std::hypot(v.x(), v.y()) < 0.6) middle.extend(v.cast<double>());
    }
    const double cusp = boundingBox(molar.outer).max().z();
    EXPECT_NEAR(cusp - middle.max().z(), 6.36, 0.5);
    EXPECT_NEAR(cusp - middle.min().z(), 7.95, 0.5);
}

TEST(BuiltinTooth, MolarHasTwoRootsThatPartBelowTheNeck) {
    const TriangleMesh& outer = toothOf(LowerFirstMolar).outer;
    const auto isSolid = [&](double z) { return isInside(outer, Vec3(-0.1, 0, z)); };
    EXPECT_TRUE(isSolid(-2.0));
    EXPECT_FALSE(isSolid(-5.0));
    EXPECT_TRUE(isInside(outer, Vec3(-2.7, 0, -6)));
    EXPECT_TRUE(isInside(outer, Vec3(2.8, 0, -6)));
}

/// The tips of the molar's cusps.
std::vector<Vec3f> molarCusps() {
    std::vector<Vec3f> top;
    for (const Vec3f& v : toothOf(LowerFirstMolar).outer.vertices) {
        if (v.z() > 5.8) top.push_back(v);
    }
    constexpr float kApart = 1.0;  // mm; nearer heights belong to one cusp
    std::vector<Vec3f> peaks;
    std::ranges::copy_if(top, std::back_inserter(peaks), [&](const Vec3f& v) {
        return std::ranges::none_of(top, [&](const Vec3f& w) { return w.z() > v.z() && (w - v).norm() < kApart; });
    });
    return peaks;
}

TEST(BuiltinTooth, MolarHasFiveCusps) { EXPECT_EQ(molarCusps().size(), 5u); }

TEST(BuiltinTooth, MesialIsOnTheSideOfTheMouthThatTheNumberNames) {
    for (const int fdi : {11, 13, 18, 31, 36, 55, 75}) EXPECT_EQ(mesialX(fdi), 1) << fdi;
    for (const int fdi : {21, 23, 28, 41, 46, 65, 85}) EXPECT_EQ(mesialX(fdi), -1) << fdi;
}

/// In a right-handed frame of the patient (+x to the patient's right, +y to the front, +z upward) mesial of a lower
/// right molar points to the front and its cheek side to the right: its own frame must turn into that without a
/// reflection.
TEST(BuiltinTooth, TheLowerRightMolarFitsIntoTheRightSideOfTheMouth) {
    const BuiltinTooth& molar = toothOf(LowerFirstMolar);
    ASSERT_EQ(molar.fdi, 46);
    // The fifth cusp is the lowest and the most distal one; it is on the buccal side.
    const std::vector<Vec3f> cusps = molarCusps();
    const Vec3f lowest = *std::ranges::min_element(cusps, {}, [](const Vec3f& v) { return v.z(); });
    EXPECT_LT(lowest.x() * mesialX(molar.fdi), -2.5);
    EXPECT_GT(lowest.y(), 0.5);
    Mat3 tooth, mouth;
    tooth << mesialX(molar.fdi) * Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ();
    mouth << Vec3::UnitY(), Vec3::UnitX(), Vec3::UnitZ();
    EXPECT_DOUBLE_EQ((mouth * tooth.inverse()).determinant(), 1);
}

TEST(BuiltinTooth, IsTheSameOnAnyNumberOfThreads) {
    for (const Average& average : kTestedAverages) {
        const BuiltinTooth onMany = makeBuiltinTooth(average.kind);
        const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        const BuiltinTooth onOne = makeBuiltinTooth(average.kind);
        const auto first = meshesOf(onMany), second = meshesOf(onOne);
        for (std::size_t i = 0; i < first.size(); ++i) EXPECT_TRUE(test::areBitEqual(*first[i], *second[i]));
    }
}

}  // namespace
}  // namespace tactooth
