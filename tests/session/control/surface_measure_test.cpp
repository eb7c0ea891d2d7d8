// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/control/surface_measure.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "geometry/util/degree.h"
#include "support/materials.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

Surface surfaceOf(TriangleMesh mesh) {
    Surface surface;
    surface.base = std::make_shared<const SurfacePart>(std::move(mesh));
    return surface;
}

double degreesBetween(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)) / kDegree; }

/// Two planes that meet in the y axis: level on the left, and on the right lower by `slope` (rad); above and outside is
/// +z. Each is 10 mm wide and is cut into `pieces` strips.
Surface roof(double slope, int pieces) {
    TriangleMesh mesh;
    const auto strip = [&](const Vec3& from, const Vec3& to) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const double y : {-10.0, 10.0}) {
            for (const Vec3& x : {from, to}) mesh.vertices.push_back((x + Vec3(0, y, 0)).cast<float>());
        }
        mesh.triangles.push_back({first, first + 1, first + 3});
        mesh.triangles.push_back({first, first + 3, first + 2});
    };
    const Vec3 down(std::cos(slope), 0, -std::sin(slope));
    for (int i = 0; i < pieces; ++i) {
        const double a = 10.0 * i / pieces, b = 10.0 * (i + 1) / pieces;
        strip(Vec3(-b, 0, 0), Vec3(-a, 0, 0));
        strip(a * down, b * down);
    }
    return surfaceOf(std::move(mesh));
}

Ray downAt(double x, double y) { return {Vec3(x, y, 20), -Vec3::UnitZ()}; }

/// Closed form: the chord of a sphere.
TEST(SurfaceMeasure, DistancesOnABallAreItsChords) {
    const Vec3 centre(1, 2, 3);
    const double radius = 4;
    const Surface ball = surfaceOf(test::sphere(centre, radius, 256, 128));
    std::mt19937 random(11);
    std::normal_distribution<double> normal;
    const auto direction = [&] { return Vec3(normal(random), normal(random), normal(random)).normalized(); };
    for (int i = 0; i < 300; ++i) {
        const Vec3 a = direction(), b = direction();
        SurfaceMeasure measure(MeasureKind::Distance);
        for (const Vec3& each : {a, b}) {
            const auto place = placeOn(ball, Ray{centre + 10 * each, -each});
            ASSERT_TRUE(place);
            measure.add(*place);
        }
        const double chord = 2 * radius * std::sin(degreesBetween(a, b) * kDegree / 2);
        EXPECT_NEAR(measure.result().value(), chord, 0.005) << i;
    }
}

/// Closed form: the normals of a sphere are its radii.
TEST(SurfaceMeasure, AnglesOnABallAreThoseOfItsRadii) {
    const Surface ball = surfaceOf(test::sphere(Vec3::Zero(), 4, 256, 128));
    std::mt19937 random(12);
    std::normal_distribution<double> normal;
    const auto direction = [&] { return Vec3(normal(random), normal(random), normal(random)).normalized(); };
    for (int i = 0; i < 100; ++i) {
        const Vec3 a = direction(), b = direction();
        SurfaceMeasure measure(MeasureKind::Angle);
        for (const Vec3& each : {a, b}) measure.add(placeOn(ball, Ray{10 * each, -each}).value());
        EXPECT_NEAR(measure.result().value(), degreesBetween(a, b), 0.5) << i;
    }
}

TEST(SurfaceMeasure, TheAngleOfTwoPlanesIsExactAwayFromTheirEdge) {
    for (const double degrees : {0.0, 1.0, 12.5, 30.0, 45.0, 60.0}) {
        const Surface planes = roof(degrees * kDegree, 7);
        SurfaceMeasure measure(MeasureKind::Angle);
        measure.add(placeOn(planes, downAt(-2, 1)).value());
        EXPECT_FALSE(measure.result());
        measure.add(placeOn(planes, downAt(1.5, -3)).value());
        EXPECT_NEAR(measure.result().value(), degrees, 1e-4);
    }
}

TEST(SurfaceMeasure, WallsThatFaceEachOtherHaveAnAngleOf180Degrees) {
    const Surface box = surfaceOf(test::box(Vec3(0, 0, 0), Vec3(4, 4, 4)));
    SurfaceMeasure measure(MeasureKind::Angle);
    measure.add(placeOn(box, Ray{Vec3(-5, 2, 2), Vec3::UnitX()}).value());
    measure.add(placeOn(box, Ray{Vec3(9, 2, 2), -Vec3::UnitX()}).value());
    EXPECT_NEAR(measure.result().value(), 180, 1e-6);
    measure.add(placeOn(box, Ray{Vec3(2, 2, 9), -Vec3::UnitZ()}).value());
    EXPECT_FALSE(measure.result());  // the third place begins anew
    measure.add(placeOn(box, Ray{Vec3(2, 9, 2), -Vec3::UnitY()}).value());
    EXPECT_NEAR(measure.result().value(), 90, 1e-6);
    measure.clear();
    EXPECT_TRUE(measure.places().empty());
}

/// On the edge, half of the disc has each normal: the mean is that of the two.
TEST(SurfaceMeasure, TheNormalIsAveragedOverTheDisc) {
    const double slope = 40 * kDegree;
    const Surface planes = roof(slope, 5);
    const Vec3 level = Vec3::UnitZ(), sloped(std::sin(slope), 0, std::cos(slope));
    const auto at = [&](double x) { return placeOn(planes, downAt(x, 0)).value().normal; };
    EXPECT_LT(degreesBetween(at(1e-9), (level + sloped).normalized()), 0.5);
    EXPECT_LT(degreesBetween(at(-1.05 * kNormalDisc), level), 1e-4);
    EXPECT_GT(degreesBetween(at(-0.5 * kNormalDisc), level), 2);
    EXPECT_GT(degreesBetween(at(-0.5 * kNormalDisc), sloped), 20);
}

/// The mean does not depend on how a plane is cut into triangles.
TEST(SurfaceMeasure, LargeAndSmallTrianglesGiveTheSameNormal) {
    const auto normal = [](int pieces) { return placeOn(roof(0.6, pieces), downAt(0.1, 0)).value().normal; };
    EXPECT_LT(degreesBetween(normal(1), normal(300)), 0.01);
}

TEST(SurfaceMeasure, ARoughSurfaceHasTheNormalOfItsMeanPlane) {
    constexpr int kSide = 80;
    constexpr double kStep = 0.05, kRoughness = 0.004;  // mm
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-kRoughness, kRoughness);
    TriangleMesh mesh;
    for (int j = 0; j <= kSide; ++j) {
        for (int i = 0; i <= kSide; ++i) {
            mesh.vertices.push_back(
                Vec3(kStep * (i - kSide / 2.0), kStep * (j - kSide / 2.0), uniform(random)).cast<float>());
        }
    }
    for (std::uint32_t j = 0; j < kSide; ++j) {
        for (std::uint32_t i = 0; i < kSide; ++i) {
            const std::uint32_t at = j * (kSide + 1) + i, above = at + kSide + 1;
            mesh.triangles.push_back({at, at + 1, above + 1});
            mesh.triangles.push_back({at, above + 1, above});
        }
    }
    const Surface rough = surfaceOf(std::move(mesh));
    double worst = 0;
    for (int i = 0; i < 20; ++i) {
        worst =
            std::max(worst, degreesBetween(placeOn(rough, downAt(0.05 * i, 0.02 * i)).value().normal, Vec3::UnitZ()));
    }
    EXPECT_LT(worst, 1.5);  // a single triangle leans by up to ten degrees
}

/// A stump with four walls that lean by `lean` (degrees: -x, +x, -y, +y) to the axis z; its top is a square of 4 mm.
Surface stump(const std::array<double, 4>& lean) {
    constexpr double kHalf = 2, kHeight = 4;  // mm
    TriangleMesh mesh = test::box(Vec3(-kHalf, -kHalf, -kHeight), Vec3(kHalf, kHalf, 0));
    for (auto& vertex : mesh.vertices) {
        if (vertex.z() == 0) continue;
        const double x = kHeight * std::tan(kDegree * lean[vertex.x() < 0 ? 0 : 1]);
        const double y = kHeight * std::tan(kDegree * lean[vertex.y() < 0 ? 2 : 3]);
        vertex.x() += static_cast<float>(vertex.x() < 0 ? -x : x);
        vertex.y() += static_cast<float>(vertex.y() < 0 ? -y : y);
    }
    return surfaceOf(std::move(mesh));
}

/// Closed form: walls of which each leans as it was built, seen along any axis.
TEST(SurfaceMeasure, ATaperIsTheSumOfTheLeansOfBothWalls) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> degrees(-12, 25);
    for (int i = 0; i < 50; ++i) {
        const std::array<double, 4> lean{degrees(random), degrees(random), degrees(random), degrees(random)};
        const Surface surface = stump(lean);
        SurfaceMeasure measure(MeasureKind::Taper);
        measure.add(placeOn(surface, Ray{Vec3(-9, 0, -2), Vec3::UnitX()}).value());
        EXPECT_FALSE(measure.result().has_value());
        measure.add(placeOn(surface, Ray{Vec3(9, 0, -2), -Vec3::UnitX()}).value());
        EXPECT_NEAR(measure.leans().value()[0], lean[0], 0.01);
        EXPECT_NEAR(measure.leans().value()[1], lean[1], 0.01);
        EXPECT_NEAR(measure.result().value(), lean[0] + lean[1], 0.02);
        // A tilted direction of insertion takes from the one wall what it gives to the other.
        SurfaceMeasure tilted(MeasureKind::Taper, Vec3(std::sin(0.1), 0, std::cos(0.1)));
        for (const MeasuredPlace& place : measure.places()) tilted.add(place);
        EXPECT_NEAR(tilted.leans().value()[0], lean[0] - 0.1 / kDegree, 0.01);
        EXPECT_NEAR(tilted.result().value(), lean[0] + lean[1], 0.02);
    }
}

TEST(SurfaceMeasure, OnlyOppositeWallsHaveATaper) {
    const Surface surface = stump({5, 5, 5, 5});
    const MeasuredPlace left = placeOn(surface, Ray{Vec3(-9, 0, -2), Vec3::UnitX()}).value();
    const MeasuredPlace front = placeOn(surface, Ray{Vec3(0, -9, -2), Vec3::UnitY()}).value();
    const MeasuredPlace top = placeOn(surface, downAt(0.2, 0.1)).value();
    for (const MeasuredPlace& other : {front, top, left}) {
        SurfaceMeasure measure(MeasureKind::Taper);
        measure.add(left);
        measure.add(other);
        EXPECT_FALSE(measure.result().has_value());
    }
}

/// Closed form: a ball as pulp.
TEST(SurfaceMeasure, RemainingDentinIsTheDistanceFromThePulp) {
    const Vec3 centre(0.3, -0.2, -2);
    const double radius = 0.7;
    std::vector<LayerMesh> layers;
    layers.push_back({"pulp", test::kPulp, test::sphere(centre, radius, 256, 128)});
    const auto tooth = LayeredTooth::make(test::box(Vec3(-3, -3, -4), Vec3(3, 3, 0)), std::move(layers), test::kDentin);
    ASSERT_TRUE(tooth.has_value());
    const Surface surface = surfaceOf(test::box(Vec3(-3, -3, -4), Vec3(3, 3, 0)));
    for (const double x : {-2.5, -0.4, 0.31, 2.2}) {
        SurfaceMeasure measure(MeasureKind::RemainingDentin);
        for (int twice = 0; twice < 2; ++twice) {  // each place is a measurement of its own
            const MeasuredPlace place = placeOn(surface, downAt(x, 0.17)).value();
            measure.add(place, nearestPulp(*tooth, place.point));
            EXPECT_EQ(measure.places().size(), 2U);
            EXPECT_NEAR(measure.result().value(), (place.point - centre).norm() - radius, 1e-3);
        }
    }
    EXPECT_EQ(nearestPulp(*tooth, centre + Vec3(0.1, 0.2, 0)).value(), Vec3(centre + Vec3(0.1, 0.2, 0)));
    const auto sound = LayeredTooth::make(test::box(Vec3(-3, -3, -4), Vec3(3, 3, 0)), {}, test::kDentin);
    EXPECT_FALSE(nearestPulp(*sound, centre).has_value());
    SurfaceMeasure measure(MeasureKind::RemainingDentin);
    measure.add(placeOn(surface, downAt(0, 0)).value(), std::nullopt);
    EXPECT_FALSE(measure.result().has_value());
}

TEST(SurfaceMeasure, ARayThatMissesMeasuresNothing) {
    const Surface box = surfaceOf(test::box(Vec3(0, 0, 0), Vec3(1, 1, 1)));
    EXPECT_FALSE(placeOn(box, Ray{Vec3(5, 5, 5), Vec3::UnitZ()}));
}

}  // namespace
}  // namespace tactooth
