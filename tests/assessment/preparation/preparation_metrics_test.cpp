// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/preparation/preparation_metrics.h"

#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <set>

#include "assessment/preparation/prepared_blocks.h"
#include "geometry/mesh/subdivide.h"
#include "geometry/util/degree.h"
#include "geometry/util/parallel_for.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

using namespace test;

constexpr double kLength = 0.02, kAngle = 0.5, kShare = 0.01;  // what has to be reached: mm, degrees, of a volume

const TriangleMesh kIdeal = blockWithBox(-2, 2, -1.5, 1.5, 3);  // 4 x 3 mm, 2 mm deep

PreparationMeasures measured(const TriangleMesh& student, const TriangleMesh& ideal = kIdeal) {
    return PreparationMeasures(blockPreparation(student, ideal));
}

/// A cavity like the ideal one whose wall at x = 2 leans outwards by `degrees` toward its opening.
TriangleMesh withLeaningWall(double degrees) {
    return blockWithCavityTo(Rectangle::level(-2, 2 + 2 * std::tan(degrees * kDegree), -1.5, 1.5, 5),
                             Rectangle::level(-2, 2, -1.5, 1.5, 3));
}

TEST(PreparationMetrics, HaveUniqueIdsUnitsAndDefinitions) {
    std::set<std::string_view> ids;
    for (const PreparationMetric& each : preparationMetrics()) {
        SCOPED_TRACE(each.id);
        EXPECT_TRUE(ids.insert(each.id).second);
        EXPECT_THAT(
            (std::array<std::string_view, 10>{"mm", "mm^2", "mm^3", "deg", "1", "s", "N", "N*s", "Hz", "mm^3/s"}),
            testing::Contains(each.unit));
        EXPECT_TRUE(each.form == ValueForm::Measure || each.unit == "1");
        EXPECT_TRUE(each.definition.ends_with('.'));
        EXPECT_FALSE(each.title.empty());
    }
}

TEST(PreparationMetrics, OfTheIdealPreparationAreIdeal) {
    const PreparationMeasures same = measured(kIdeal);
    EXPECT_NEAR(valueOf(same, "cleared_share"), 1, kShare);
    EXPECT_NEAR(valueOf(same, "dice"), 1, kShare);
    for (const char* id : {"over_max", "over_volume", "under_volume", "deviation_rms", "floor_flatness", "floor_tilt"})
        EXPECT_NEAR(valueOf(same, id), 0, 1e-4) << id;
    EXPECT_NEAR(valueOf(same, "within_0_1"), 1, 1e-9);
}

TEST(PreparationMetrics, OfACavityTooDeepAreItsClosedForm) {
    const PreparationMeasures deep = measured(blockWithBox(-2, 2, -1.5, 1.5, 2.7));
    EXPECT_NEAR(valueOf(deep, "over_max"), 0.3, kLength);
    EXPECT_NEAR(valueOf(deep, "over_volume"), 3.6, kShare * 3.6);
    EXPECT_NEAR(valueOf(deep, "under_volume"), 0, 0.01);
    EXPECT_NEAR(valueOf(deep, "dice"), 2 * 24 / (24 + 27.6), kShare);
    EXPECT_NEAR(valueOf(deep, "floor_depth_median"), 2.3, kLength);
    // The floor lies 0.3 mm too deep, the lowest 0.3 mm of the walls from 0 to 0.3 mm, and the rest is right.
    const double floor = 12, low = 14 * 0.3, rest = 14 * (2 - kCavityDepth), all = floor + low + rest;
    EXPECT_NEAR(valueOf(deep, "deviation_rms"), std::sqrt((floor * 0.09 + low * 0.03) / all), 0.005);
    EXPECT_NEAR(valueOf(deep, "within_0_1"), (rest + low / 3) / all, kShare);
    EXPECT_NEAR(valueOf(deep, "within_0_2"), (rest + low * 2 / 3) / all, kShare);
    EXPECT_NEAR(valueOf(deep, "within_0_4"), 1, 1e-9);
}

TEST(PreparationMetrics, OfTheDeviationAreItsMeanAndPercentiles) {
    // The floor lies 0.3 mm off, the lowest 0.3 mm of the walls from 0 to 0.3 mm, and the rest is right.
    const PreparationMeasures deep = measured(blockWithBox(-2, 2, -1.5, 1.5, 2.7));
    const double floor = 12, low = 14 * 0.3, all = floor + low + 14 * (2 - kCavityDepth);
    EXPECT_NEAR(valueOf(deep, "deviation_mean"), -(floor * 0.3 + low * 0.15) / all, 0.005);
    EXPECT_NEAR(valueOf(deep, "deviation_p50"), 0, kLength);
    EXPECT_NEAR(valueOf(deep, "deviation_p95"), 0.3, kLength);
    const PreparationMeasures shallow = measured(blockWithBox(-2, 2, -1.5, 1.5, 3.3));
    const double walls = 14 * (1.7 - kCavityDepth);  // right; the floor is not cut to its depth
    // Beside a wall the floor is as far from the ideal surface as from the wall.
    const double left = 12 * 0.3 - 7 * 0.3 * 0.3 + 4.0 / 3 * 0.3 * 0.3 * 0.3;
    EXPECT_NEAR(valueOf(shallow, "deviation_mean"), left / (floor + walls), 0.005);
    EXPECT_NEAR(valueOf(measured(kIdeal), "deviation_mean"), 0, 1e-4);
    EXPECT_NEAR(valueOf(measured(kIdeal), "deviation_p95"), 0, 1e-4);
}

TEST(PreparationMetrics, OfTheFloorAreItsLeastAndGreatestDepth) {
    // From 2.2 to 1.8 mm over 4 mm; the strip of 0.3 mm along the border does not count.
    const PreparationMeasures tilted =
        measured(blockWithCavityTo(Rectangle::level(-2, 2, -1.5, 1.5, 5), Rectangle{-2, 2, -1.5, 1.5, 2.8, 3.2}));
    const double slope = 0.1;
    EXPECT_NEAR(valueOf(tilted, "floor_depth_min"), 2 - 1.7 * slope, kLength);
    EXPECT_NEAR(valueOf(tilted, "floor_depth_p5"), 2 - 0.9 * 1.7 * slope, kLength);
    EXPECT_NEAR(valueOf(tilted, "floor_depth_median"), 2, kLength);
    EXPECT_NEAR(valueOf(tilted, "floor_depth_p95"), 2 + 0.9 * 1.7 * slope, kLength);
    EXPECT_NEAR(valueOf(tilted, "floor_depth_max"), 2 + 1.7 * slope, kLength);
}

TEST(PreparationMetrics, OfVolumeBeyondTheToleranceIsWhatLiesFartherFromTheIdeal) {
    Preparation deep = blockPreparation(blockWithBox(-2, 2, -1.5, 1.5, 2.5), kIdeal);
    // Below the whole floor lie 0.5 mm too much: all of it is as far from the ideal floor as it is deep.
    for (const double tolerance : {0.1, 0.2, 0.3}) {
        deep.tolerance = tolerance;
        const double beyond = 12 * (0.5 - tolerance);
        EXPECT_NEAR(valueOf(PreparationMeasures(deep), "over_volume_beyond"), beyond, kShare * 6 + 0.02);
    }
    EXPECT_NEAR(valueOf(measured(blockWithBox(-2, 2.2, -1.5, 1.5, 3)), "over_volume_beyond"), 0, 0.01);
}

TEST(PreparationMetrics, OfAnUndercutOfAScanNeedTwoDegrees) {
    for (const double degrees : {1.5, 3.0}) {
        // The wall at x = -2 leans so that the cavity is wider at its floor.
        const double out = 2 * std::tan(degrees * kDegree);
        const PreparationMeasures under = measured(
            blockWithCavityTo(Rectangle::level(-2, 2, -1.5, 1.5, 5), Rectangle::level(-2 - out, 2, -1.5, 1.5, 3)));
        const double wall = 3 * (2 - kCavityDepth) / std::cos(degrees * kDegree);
        EXPECT_GT(valueOf(under, "undercut_area"), wall * 0.97);
        if (degrees > 2) {
            EXPECT_GT(valueOf(under, "undercut_area_scan"), wall * 0.97);
        } else {
            // The strip of the floor that the wall hangs over is hidden all the same.
            EXPECT_LT(valueOf(under, "undercut_area_scan"), 3 * out + 0.4);
        }
        EXPECT_LE(valueOf(under, "undercut_area_scan"), valueOf(under, "undercut_area") + 1e-9);
    }
}

TEST(PreparationMetrics, OfACavityTooShallowHaveNoOverPreparation) {
    const PreparationMeasures shallow = measured(blockWithBox(-2, 2, -1.5, 1.5, 3.5));
    EXPECT_NEAR(valueOf(shallow, "over_max"), 0, 1e-4);
    EXPECT_NEAR(valueOf(shallow, "over_volume"), 0, 0.01);
    EXPECT_NEAR(valueOf(shallow, "under_volume"), 6, kShare * 6);
    EXPECT_NEAR(valueOf(shallow, "cleared_share"), 0.75, kShare);
    EXPECT_NEAR(valueOf(shallow, "floor_depth_median"), 1.5, kLength);
}

TEST(PreparationMetrics, OfACavityTooWideOnOneSideNameThePlace) {
    const PreparationMeasures wide = measured(blockWithBox(-2, 2.2, -1.5, 1.5, 3));
    const Measured& overMax = wide.deviation.overMax;
    EXPECT_NEAR(*overMax.value, 0.2, kLength);
    EXPECT_NEAR(overMax.place->x(), 2.2, 1e-5);
    EXPECT_NEAR(valueOf(wide, "over_volume"), 0.2 * 3 * 2, kShare * 1.2 + 0.01);
    EXPECT_NEAR(valueOf(wide, "extent_md"), 4.2, kLength);
    EXPECT_NEAR(valueOf(wide, "extent_bl"), 3, kLength);
    EXPECT_NEAR(valueOf(wide, "extent_og"), 2 - kCavityDepth, kLength);
}

TEST(PreparationMetrics, MeasureTheAnglesOfWallsOnTheirSides) {
    for (const double angle : {-5.0, 5.0, 12.0}) {
        const PreparationMeasures leaning = measured(withLeaningWall(angle));
        EXPECT_NEAR(valueOf(leaning, "wall_angle_m"), -angle, kAngle);  // mesial is +x; narrower outside is positive
        EXPECT_NEAR(valueOf(leaning, "wall_angle_d"), 0, kAngle);
        EXPECT_NEAR(valueOf(leaning, "wall_angle_b"), 0, kAngle);
        EXPECT_NEAR(valueOf(leaning, "wall_angle_l"), 0, kAngle);
    }
    Preparation mirrored = blockPreparation(withLeaningWall(5), kIdeal);
    mirrored.mesialX = -1;
    EXPECT_NEAR(valueOf(PreparationMeasures(mirrored), "wall_angle_d"), -5, kAngle);
}

TEST(PreparationMetrics, MeasureATiltedFloor) {
    for (const double tilt : {1.0, 4.0, 10.0}) {
        const double rise = 2 * std::tan(tilt * kDegree);
        const PreparationMeasures tilted = measured(
            blockWithCavityTo(Rectangle::level(-2, 2, -1.5, 1.5, 5), Rectangle{-2, 2, -1.5, 1.5, 3 - rise, 3 + rise}));
        EXPECT_NEAR(valueOf(tilted, "floor_tilt"), tilt, kAngle / 10);
        EXPECT_NEAR(valueOf(tilted, "floor_flatness"), 0, 1e-3);
        EXPECT_NEAR(valueOf(tilted, "floor_depth_median"), 2, kLength);
    }
}

TEST(PreparationMetrics, MeasureACurvedFloor) {
    const auto bump = [](double x, double y) { return 0.3 * (1 - x * x / 4) * (1 - y * y / 2.25); };
    TriangleMesh curved = subdivided(kIdeal, 5);
    for (Vec3f& vertex : curved.vertices) {
        if (vertex.z() == 3) vertex.z() += static_cast<float>(bump(vertex.x(), vertex.y()));
    }
    double count = 0, sum = 0, squares = 0;  // of the bump, without the strip along the border
    for (double x = -1.69; x < 1.7; x += 0.02) {
        for (double y = -1.19; y < 1.2; y += 0.02) {
            count += 1;
            sum += bump(x, y);
            squares += bump(x, y) * bump(x, y);
        }
    }
    const double rms = std::sqrt(squares / count - sum / count * sum / count);
    EXPECT_GT(rms, 0.05);
    EXPECT_NEAR(valueOf(measured(curved), "floor_flatness"), rms, 0.003);
    EXPECT_NEAR(valueOf(measured(curved), "floor_tilt"), 0, kAngle);
}

TEST(PreparationMetrics, FindAnUndercutOfATenthOfAMillimetre) {
    const PreparationMeasures under =
        measured(blockWithCavityTo(Rectangle::level(-2, 2, -1.5, 1.5, 5), Rectangle::level(-2.1, 2, -1.5, 1.5, 3)));
    EXPECT_NEAR(valueOf(under, "undercut_depth"), 0.1, 0.005);
    EXPECT_LT(under.undercut.depth.place->x(), -2.05);
    // The wall that leans over, the strip of floor below it and a triangle of both walls beside it.
    const double wall = 3 * std::hypot(2, 0.1) * (1 - kCavityDepth / 2), strip = 0.3, sides = 2 * 0.1;
    EXPECT_NEAR(valueOf(under, "undercut_area"), wall + strip + sides, 0.02 * wall);
    const PreparationMeasures none = measured(withLeaningWall(5));
    EXPECT_EQ(valueOf(none, "undercut_area"), 0);
    EXPECT_EQ(valueOf(none, "undercut_depth"), 0);
}

TEST(PreparationMetrics, FindTheInsertionThatFreesAWallThatLeans) {
    // The wall at x = -2 leans out by 2.9 degrees, that at x = 2 gives way by 5: an insertion between frees both.
    const double out = 2 * std::tan(5 * kDegree);
    const PreparationMeasures free = measured(
        blockWithCavityTo(Rectangle::level(-2, 2 + out, -1.5, 1.5, 5), Rectangle::level(-2.1, 2, -1.5, 1.5, 3)));
    EXPECT_GT(valueOf(free, "undercut_area"), 5);
    EXPECT_EQ(valueOf(free, "undercut_area_best"), 0);
    // Both lean out: an insertion of 2 degrees frees one wall, and hides 0.17 mm of floor under the other.
    const PreparationMeasures stuck =
        measured(blockWithCavityTo(Rectangle::level(-2, 2, -1.5, 1.5, 5), Rectangle::level(-2.1, 2.1, -1.5, 1.5, 3)));
    const double wall = 3 * std::hypot(2, 0.1) * (1 - kCavityDepth / 2), tilt = 2 * std::tan(2 * kDegree);
    EXPECT_NEAR(valueOf(stuck, "undercut_area"), 2 * (wall + 0.3 + 0.2), 0.4);
    EXPECT_NEAR(valueOf(stuck, "undercut_area_best"), wall + 3 * (0.1 + tilt) + 3 * (0.1 - tilt) + 0.3, 0.4);
}

TEST(PreparationMetrics, MeasureRidgesAndIsthmus) {
    const PreparationMeasures slot = measured(blockWithBox(-3.6, 3, -0.55, 0.55, 3.5));
    EXPECT_NEAR(valueOf(slot, "ridge_min_d"), 1.4, kLength);
    EXPECT_NEAR(valueOf(slot, "ridge_min_m"), 2, kLength);
    EXPECT_NEAR(valueOf(slot, "ridge_kept"), 2, kLength) << "the larger";
    EXPECT_NEAR(valueOf(slot, "isthmus_min"), 1.1, kLength);
    EXPECT_EQ(reasonOf(measured(kIdeal), "isthmus_min"), "no_isthmus");
}

/// As in a premolar, where the box is half as wide as the whole cavity is long.
TEST(PreparationMetrics, MeasureTheIsthmusBesideAWideBox) {
    const PreparationMeasures shape = measured(blockWithSlotAndBox());
    EXPECT_NEAR(valueOf(shape, "extent_md"), 5.4, kLength);
    EXPECT_NEAR(valueOf(shape, "extent_bl"), 2.8, kLength);
    EXPECT_NEAR(valueOf(shape, "isthmus_min"), 1.2, kLength);
}

TEST(PreparationMetrics, KnowAnOpenedPulp) {
    Preparation preparation = blockPreparation(kIdeal, kIdeal);
    EXPECT_EQ(reasonOf(PreparationMeasures(preparation), "pulp_open"), "no_pulp_known");
    const auto withPulpUpTo = [&](double z) {
        preparation.pulps = {std::make_shared<const SurfacePart>(box(Vec3(-1, -1, -3), Vec3(1, 1, z)))};
        return PreparationMeasures(preparation);
    };
    EXPECT_NEAR(valueOf(withPulpUpTo(2.25), "remaining_dentin_min"), 0.75, 1e-4);
    EXPECT_EQ(valueOf(withPulpUpTo(2.99), "pulp_open"), 0);
    EXPECT_EQ(valueOf(withPulpUpTo(3.01), "pulp_open"), 1);
    EXPECT_EQ(valueOf(withPulpUpTo(3.01), "remaining_dentin_min"), 0);
}

TEST(PreparationMetrics, MeasureAScratchInTheNeighbour) {
    Preparation preparation = blockPreparation(kIdeal, kIdeal);
    EXPECT_EQ(reasonOf(PreparationMeasures(preparation), "neighbour_depth_max"), "no_neighbour_known");
    preparation.neighbours = std::make_shared<const SurfacePart>(box(Vec3(6, -5, -5), Vec3(16, 5, 5)));
    EXPECT_EQ(valueOf(PreparationMeasures(preparation), "neighbour_depth_max"), 0);
    for (const double depth : {0.06, 0.25}) {
        preparation.cutNeighbours = box(Vec3(5.9, -1, 1), Vec3(6 + depth, 1, 3));
        EXPECT_NEAR(valueOf(PreparationMeasures(preparation), "neighbour_depth_max"), depth, 1e-4);
    }
}

TEST(PreparationMetrics, CountScratchesAndNicksInTheNeighbour) {
    Preparation preparation = blockPreparation(kIdeal, kIdeal);
    EXPECT_EQ(reasonOf(PreparationMeasures(preparation), "neighbour_scratches"), "no_neighbour_known");
    EXPECT_EQ(reasonOf(PreparationMeasures(preparation), "neighbour_nicks"), "no_neighbour_known");
    preparation.neighbours = std::make_shared<const SurfacePart>(box(Vec3(6, -5, -5), Vec3(16, 5, 5)));
    EXPECT_EQ(valueOf(PreparationMeasures(preparation), "neighbour_scratches"), 0);
    double y = -4;
    for (const double depth : {0.03, 0.06, 0.15, 0.25, 0.6}) {
        append(preparation.cutNeighbours, box(Vec3(5.9, y, 1), Vec3(6 + depth, y + 1, 3)));
        y += 1.5;
    }
    EXPECT_EQ(valueOf(PreparationMeasures(preparation), "neighbour_scratches"), 4);
    EXPECT_EQ(valueOf(PreparationMeasures(preparation), "neighbour_nicks"), 2);
    // Two cuts that meet are one.
    append(preparation.cutNeighbours, box(Vec3(5.9, -4, -2), Vec3(6.1, -3, -1)));
    append(preparation.cutNeighbours, box(Vec3(5.9, -4, -3), Vec3(6.1, -3, -2)));
    EXPECT_EQ(valueOf(PreparationMeasures(preparation), "neighbour_scratches"), 5);
}

/// A zone of 4 x 2 mm, of which the cavity from x = -2 to 2 and y = -1.5 to 1.5, 2 mm deep, takes 2 x 1 mm.
TEST(PreparationMetrics, CountWhatIsCutBelowTheOutlineOfAForbiddenZone) {
    Preparation preparation = blockPreparation(blockWithBox(-2, 2, -1.5, 1.5, 3), kIdeal);
    EXPECT_EQ(reasonOf(PreparationMeasures(preparation), "forbidden_volume"), "no_forbidden_zone");
    const ForbiddenZone zone{.corners = {{0, 0.5, 5}, {4, 0.5, 5}, {4, 2.5, 5}, {0, 2.5, 5}}, .outward = Vec3::UnitZ()};
    preparation.forbidden = {zone};
    EXPECT_NEAR(valueOf(PreparationMeasures(preparation), "forbidden_volume"), 2 * 1 * 2, 4 * kShare);
    preparation.forbidden = {{.corners = {{3, 0, 5}, {4, 0, 5}, {4, 2, 5}}, .outward = Vec3::UnitZ()}};
    EXPECT_EQ(valueOf(PreparationMeasures(preparation), "forbidden_volume"), 0);
    // The same zone seen from the side, over the upper 2 mm: 4 mm of the cavity lie behind 1 mm of its height.
    preparation.forbidden = {
        {.corners = {{5, -0.5, 4}, {5, 0.5, 4}, {5, 0.5, 6}, {5, -0.5, 6}}, .outward = Vec3::UnitX()}, zone};
    EXPECT_NEAR(valueOf(PreparationMeasures(preparation), "forbidden_volume"), 4 * 1 * 1 + 4, 8 * kShare);
    preparation.prepared = preparation.original;
    EXPECT_EQ(valueOf(PreparationMeasures(preparation), "forbidden_volume"), 0);
}

TEST(PreparationMetrics, OfAnUncutToothHaveReasonsInsteadOfZeros) {
    const PreparationMeasures nothing = measured(box(Vec3(-5, -5, -5), Vec3(5, 5, 5)));
    EXPECT_EQ(valueOf(nothing, "cleared_share"), 0);
    EXPECT_EQ(valueOf(nothing, "dice"), 0);
    EXPECT_NEAR(valueOf(nothing, "under_volume"), 24, 24 * kShare);
    EXPECT_GT(valueOf(nothing, "deviation_rms"), 0.5);  // of the surface over the ideal cavity
    for (const char* id : {"floor_depth_median", "floor_tilt", "wall_angle_b", "isthmus_min", "ridge_min_m",
                           "undercut_area", "extent_md"})
        EXPECT_EQ(reasonOf(nothing, id), "nothing_cut") << id;
}

/// All values of two measures agree: lengths within 0.02 mm, angles within 0.5 degrees, others within 1 %.
void expectSame(const PreparationMeasures& one, const PreparationMeasures& other) {
    const std::map<std::string_view, double> tolerances = {
        {"mm", kLength}, {"deg", kAngle}, {"1", kShare}, {"mm^2", kShare * 26}, {"mm^3", kShare * 24}};  // of the ideal
    const auto a = measureAll(one), b = measureAll(other);
    for (std::size_t i = 0; i < a.size(); ++i) {
        SCOPED_TRACE(a[i].metric->id);
        ASSERT_EQ(a[i].measured.value.has_value(), b[i].measured.value.has_value());
        if (!a[i].measured.value) continue;
        EXPECT_NEAR(*a[i].measured.value, *b[i].measured.value, tolerances.at(a[i].metric->unit));
    }
}

const TriangleMesh kFaulty =
    blockWithCavityTo(Rectangle::level(-2.15, 2.2, -1.45, 1.5, 5), Rectangle{-2.25, 2, -1.45, 1.5, 2.7, 2.9});

TEST(PreparationMetrics, DoNotDependOnTheMesh) {
    const auto fine = [](const TriangleMesh& mesh) { return subdivided(mesh, 5); };
    Preparation divided = blockPreparation(fine(kFaulty), fine(kIdeal));
    divided.original = std::make_shared<const SurfacePart>(fine(divided.original->mesh()));
    expectSame(measured(kFaulty), PreparationMeasures(divided));
}

TEST(PreparationMetrics, DoNotDependOnThePlaceOfTheTooth) {
    const Pose moved{Vec3(31, -7, 12), Quat(Eigen::AngleAxisd(8 * kDegree, Vec3::UnitZ()))};
    Preparation preparation = blockPreparation(kFaulty, kIdeal);
    const PreparationMeasures here(preparation);
    for (auto* part : {&preparation.original, &preparation.prepared, &preparation.ideal}) {
        *part = std::make_shared<const SurfacePart>(transformed((*part)->mesh(), moved));
    }
    PreparationMeasures there(preparation);
    there.extent.mesiodistal = here.extent.mesiodistal;  // along the frame
    there.extent.buccolingual = here.extent.buccolingual;
    expectSame(here, there);
}

TEST(PreparationMetrics, AreTheSameOnOneThread) {
    const auto all = measureAll(measured(kFaulty));
    const ThreadLimit alone(1);
    const auto again = measureAll(measured(kFaulty));
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i].measured.value, again[i].measured.value);
}

}  // namespace
}  // namespace tactooth
