// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// How the teeth of different patients differ. What only the plan changes is measured on the shape of the plan; it has
// the size of the average tooth.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

#include "geometry/util/fnv1a.h"
#include "instruments/anatomy/plan_variation.h"
#include "instruments/anatomy/tooth_plans.h"
#include "instruments/builtin_tooth.h"
#include "instruments/relief_map.h"
#include "support/mesh_checks.h"
#include "support/sanitizer.h"

namespace tactooth {
namespace {

constexpr auto kSeeds = test::cases<std::uint32_t>(14, 10);

TriangleMesh surfaceOf(const ToothShape& shape) {
    constexpr double kCell = 0.3, kSlope = 1.3;  // mm: the mesh is within 0.02 mm of the surface
    return isosurface(shape.outer, shape.bounds, {kCell, kSlope, 1});
}

const TriangleMesh& plannedSurface(PosteriorToothPlan (*average)(), std::uint32_t seed) {
    static std::map<std::pair<PosteriorToothPlan (*)(), std::uint32_t>, TriangleMesh> made;
    const auto [place, isNew] = made.try_emplace({average, seed});
    if (isNew) place->second = surfaceOf(posteriorTooth(variedPlan(average(), seed)));
    return place->second;
}

std::uint64_t hashOf(const BuiltinTooth& tooth) {
    Fnv1a hash;
    for (const TriangleMesh* layer : {&tooth.outer, &tooth.enamel, &tooth.dentin, &tooth.pulp}) {
        for (const Vec3f& vertex : layer->vertices) {
            for (const float coordinate : vertex) hash.addWord(std::bit_cast<std::uint32_t>(coordinate));
        }
    }
    return hash.value();
}

double rootMeanSquare(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value * value;
    return std::sqrt(sum / static_cast<double>(values.size()));
}

// Hashes of the average teeth: only a change of their form changes them.
TEST(AnatomyVariation, LeavesTheAverageTeethAsTheyWereBitForBit) {
    EXPECT_EQ(hashOf(makeTooth({11, 2000, 0, {}})), 0x4fd745ecb954c516ULL);
    EXPECT_EQ(hashOf(makeTooth({16, 2000, 0, {}})), 0xde6d1167ed113fa7ULL);
    EXPECT_EQ(hashOf(makeTooth({45, 2000, 0, {}})), 0x83d4db26dc5fb65bULL);
}

TEST(AnatomyVariation, GivesBothSidesOfAMouthMirrorImages) {
    const TriangleMesh right = makeTooth({16, 1500, 9, {}}).outer, left = makeTooth({26, 1500, 9, {}}).outer;
    ASSERT_EQ(right.vertices.size(), left.vertices.size());
    for (std::size_t i = 0; i < right.vertices.size(); ++i) {
        const Vec3f& v = right.vertices[i];
        ASSERT_EQ(Vec3f(-v.x(), v.y(), v.z()), left.vertices[i]);
    }
}

/// The highest place near (x, y).
double heightNear(const test::ReliefMap& map, double x, double y) {
    constexpr double kReach = 0.8;  // mm: cusps move by less
    double highest = -1e9;
    for (double dx = -kReach; dx <= kReach; dx += test::ReliefMap::kCell) {
        for (double dy = -kReach; dy <= kReach; dy += test::ReliefMap::kCell) {
            if (std::hypot(dx, dy) <= kReach) highest = std::max(highest, map.at(x + dx, y + dy).value_or(-1e9));
        }
    }
    return highest;
}

TEST(AnatomyVariation, GivesTheCuspsOfAMolarOtherHeightsAndKeepsTheLengthOfItsCrown) {
    const PosteriorToothPlan average = lowerFirstMolar();
    const double length = boundingBox(plannedSurface(lowerFirstMolar, 0)).max().z();
    std::vector<double> all;
    std::vector<std::vector<double>> deviations(average.cusps.size());
    const test::ReliefMap usual(plannedSurface(lowerFirstMolar, 0), 0, 1, 2);
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
        const TriangleMesh& mesh = plannedSurface(lowerFirstMolar, seed);
        EXPECT_NEAR(boundingBox(mesh).max().z(), length, 0.03 * length) << seed;
        const test::ReliefMap map(mesh, 0, 1, 2);
        const PosteriorToothPlan plan = variedPlan(average, seed);
        for (std::size_t i = 0; i < average.cusps.size(); ++i) {
            const double is = heightNear(map, plan.cusps[i].x, plan.cusps[i].y);
            deviations[i].push_back(is - heightNear(usual, average.cusps[i].x, average.cusps[i].y));
            all.push_back(deviations[i].back());
        }
    }
    EXPECT_GE(rootMeanSquare(all), 0.1);
    EXPECT_LE(rootMeanSquare(all), 0.4);
    constexpr std::size_t kHighest = 3;  // it keeps its height in most mouths
    for (std::size_t i = 0; i < deviations.size(); ++i) {
        EXPECT_LE(rootMeanSquare(deviations[i]), 0.4) << i;
        if (i != kHighest) {
            EXPECT_GE(rootMeanSquare(deviations[i]), 0.1) << i;
        }
    }
}

/// Root mean square of the difference of two occlusal reliefs in mm, after both crowns are brought to one size and the
/// best plane is taken off.
double reliefDifference(const TriangleMesh& one, const TriangleMesh& other) {
    const auto crownBox = [](const TriangleMesh& mesh) {
        Box3 box;
        for (const Vec3f& v : mesh.vertices) {
            if (v.z() > 0) box.extend(v.cast<double>());
        }
        return box;
    };
    const Box3 a = crownBox(one), b = crownBox(other);
    const test::ReliefMap mapA(one, 0, 1, 2), mapB(other, 0, 1, 2);
    constexpr int kSteps = 24;
    constexpr double kTable = 0.6;  // share of the half diameters: the places within the marginal ridges
    std::vector<Vec3> terms;
    std::vector<double> differences;
    for (int i = -kSteps; i <= kSteps; ++i) {
        for (int j = -kSteps; j <= kSteps; ++j) {
            const Vec3 part(kTable * i / kSteps, kTable * j / kSteps, 0);
            if (part.norm() > kTable) continue;
            const Vec3 inA = a.center() + part.cwiseProduct(a.sizes()) / 2;
            const Vec3 inB = b.center() + part.cwiseProduct(b.sizes()) / 2;
            const auto heightA = mapA.at(inA.x(), inA.y()), heightB = mapB.at(inB.x(), inB.y());
            if (!heightA || !heightB) continue;
            terms.emplace_back(1, part.x(), part.y());
            differences.push_back(*heightA - *heightB * a.max().z() / b.max().z());
        }
    }
    Mat3 squares = Mat3::Zero();
    Vec3 right = Vec3::Zero();
    for (std::size_t i = 0; i < terms.size(); ++i) {
        squares += terms[i] * terms[i].transpose();
        right += differences[i] * terms[i];
    }
    const Vec3 plane = squares.ldlt().solve(right);
    for (std::size_t i = 0; i < terms.size(); ++i) differences[i] -= plane.dot(terms[i]);
    return rootMeanSquare(differences);
}

TEST(AnatomyVariation, GivesTwoPatientsOcclusalReliefsThatDifferByMoreThanSize) {
    for (const int fdi : {16, 46, 15}) {
        TriangleMesh last = surfaceOf(toothShape(fdi, 1));
        EXPECT_TRUE(test::areBitEqual(last, surfaceOf(toothShape(fdi, 1)))) << fdi;
        for (std::uint32_t seed = 2; seed <= kSeeds; ++seed) {
            TriangleMesh next = surfaceOf(toothShape(fdi, seed));
            EXPECT_GE(reliefDifference(last, next), 0.08) << fdi << " " << seed;
            last = std::move(next);
        }
    }
}

/// mm that the lingual side stands out below the mesiolingual cusp of an upper first molar, from the places beside it.
double lingualBulge(const TriangleMesh& mesh, double x, double z) {
    const test::ReliefMap lingual(mesh, 0, 2, 1, -1);
    const auto outward = [&](double atX) { return -lingual.at(atX, z).value_or(0); };
    constexpr double kMesial = 3.3, kDistal = -0.4;
    return outward(x) - std::lerp(outward(kDistal), outward(kMesial), (x - kDistal) / (kMesial - kDistal));
}

TEST(AnatomyVariation, GivesSomeUpperFirstMolarsATubercleOfCarabelli) {
    int with = 0, without = 0;
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
        const auto tubercle = variedPlan(upperFirstMolar(), seed).tubercle;
        const double x = tubercle ? tubercle->x : 1.2, z = tubercle ? tubercle->z : 3.3;
        const double bulge = lingualBulge(plannedSurface(upperFirstMolar, seed), x, z) -
                             lingualBulge(plannedSurface(upperFirstMolar, 0), x, z);
        const double height = tubercle ? tubercle->height : 0;
        EXPECT_NEAR(bulge, height, 0.12 + 0.3 * height) << seed;
        with += bulge > 0.3;
        without += !tubercle;
    }
    EXPECT_GE(with, 2);
    EXPECT_GE(without, 2);
}

/// The ends of the distal and the mesial root of a lower molar: the middle of each root 0.5 mm above its lowest place.
std::pair<Vec3, Vec3> apices(const TriangleMesh& mesh) {
    constexpr double kBetween = -1, kAbove = 0.5;  // mm: no root comes near this x
    const auto apex = [&](double side) {
        double lowest = 0;
        for (const Vec3f& v : mesh.vertices) {
            if (side * (v.x() - kBetween) > 0) lowest = std::min<double>(lowest, v.z());
        }
        Box3 box;
        for (const Vec3f& v : mesh.vertices) {
            if (side * (v.x() - kBetween) > 0 && v.z() < lowest + kAbove) box.extend(v.cast<double>());
        }
        return Vec3(box.center().x(), box.center().y(), lowest);
    };
    return {apex(-1), apex(1)};
}

TEST(AnatomyVariation, CurvesRootsMostlyToDistalAndKeepsTheirLength) {
    const auto [usualDistal, usualMesial] = apices(plannedSurface(lowerFirstMolar, 0));
    double farthest = 0, sum = 0;
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
        const auto [distal, mesial] = apices(plannedSurface(lowerFirstMolar, seed));
        for (const Vec3& moved : {Vec3(distal - usualDistal), Vec3(mesial - usualMesial)}) {
            farthest = std::max(farthest, moved.norm());
            sum += moved.x();
            EXPECT_LE(moved.norm(), 1.5) << seed;
            EXPECT_NEAR(moved.z(), 0, 0.2) << seed;
        }
    }
    EXPECT_GE(farthest, 0.5);
    EXPECT_LT(sum, 0);
}

TEST(AnatomyVariation, MovesTheCanalsWithTheirRoots) {
    for (const auto average : {upperFirstMolar, lowerFirstMolar, upperFirstPremolar}) {
        for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
            const PosteriorToothPlan before = average(), plan = variedPlan(before, seed);
            const ToothShape shape = posteriorTooth(plan);
            for (std::size_t i = 0; i < plan.canals.size(); ++i) {
                const Section& was = before.canals[i].front();
                const Section& end = plan.canals[i].front();
                EXPECT_GT(std::hypot(end.x - was.x, end.y - was.y), 0) << plan.fdi << " " << seed;
                EXPECT_LT(shape.outer(Vec3(end.x, end.y, end.z)), -0.2) << plan.fdi << " " << seed;
            }
        }
    }
}

TEST(AnatomyVariation, GivesIncisorsOtherLingualRidgesAndOtherLeaningRoots) {
    const AnteriorToothPlan average = upperCentralIncisor();
    std::vector<double> ridges, apices;
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
        const AnteriorToothPlan plan = variedPlan(average, seed);
        const ToothShape shape = anteriorTooth(plan), usual = anteriorTooth(average);
        // Within the mesial marginal ridge: how much deeper it lies there than in the average tooth, mm.
        const FaceRidge::Point& crest = average.lingual.front().points[2];
        const Vec3 place(crest.x, 0.3, crest.z);
        ridges.push_back(shape.outer(place) - usual.outer(place));
        apices.push_back(std::hypot(plan.lean - average.lean, plan.distally - average.distally));
        EXPECT_LE(apices.back(), 1.1) << seed;
    }
    EXPECT_GE(rootMeanSquare(ridges), 0.05);
    EXPECT_LE(rootMeanSquare(ridges), 0.3);
    EXPECT_GE(*std::ranges::max_element(apices), 0.5);
}

}  // namespace
}  // namespace tactooth
