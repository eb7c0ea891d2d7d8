// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/crown/crown_form.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "assessment/cavity_walls.h"
#include "assessment/preparation/preparation_metrics.h"
#include "collision/bvh/closest_point.h"
#include "geometry/mesh/mesh_report.h"
#include "support/materials.h"

namespace tactooth {
namespace {

/// The exercise on the tooth of another patient.
Exercise ofPatient(const char* id, std::uint32_t seed) {
    Exercise exercise = *builtinExercise(id);
    std::get<ToothRequest>(exercise.tooth).seed = seed;
    return exercise;
}

double valueOf(const std::vector<MetricResult>& results, std::string_view id) {
    const auto found = std::ranges::find(results, id, [](const MetricResult& each) { return each.metric->id; });
    EXPECT_TRUE(found->measured.value) << id;
    return found->measured.value.value_or(-1e9);
}

class CrownOfAnyPatient : public testing::TestWithParam<std::pair<const char*, std::uint32_t>> {};

TEST_P(CrownOfAnyPatient, HasTheFinishLineWallsAndRoomOfItsPlan) {
    const Exercise exercise = ofPatient(GetParam().first, GetParam().second);
    const auto tooth = *exerciseTooth(exercise);
    const auto& plan = std::get<PreparationPlan>(exercise.ideal);
    const Expected<TriangleMesh> ideal = idealShape(exercise, tooth);
    ASSERT_TRUE(ideal) << ideal.error().message();
    ASSERT_TRUE(reportOn(*ideal).watertight());
    Preparation preparation;
    preparation.original = tooth->ownOuter();
    preparation.prepared = preparation.ideal = std::make_shared<const SurfacePart>(*ideal);
    preparation.mesialX = tooth->toothContext().mesialX;
    const std::vector<MetricResult> results = measureAll(PreparationMeasures(preparation));
    EXPECT_NEAR(valueOf(results, "toc_md"), 2 * plan.crown->taper, 1);
    // A round end makes a wall from 30 degrees on.
    const double arc = plan.crown->tipRadius * (1 - std::cos(0.5236));
    EXPECT_NEAR(valueOf(results, "finish_line_width"), plan.crown->width - arc, 0.1);
    EXPECT_LT(valueOf(results, "finish_line_roughness"), 0.03);
    EXPECT_LT(valueOf(results, "undercut_area"), 0.2);
    EXPECT_NEAR(valueOf(results, "occlusal_reduction_median"), (plan.crown->occlusal + plan.crown->functional) / 2,
                0.5);
}

TEST_P(CrownOfAnyPatient, BeginsAboveTheEndOfTheEnamel) {
    const Exercise exercise = ofPatient(GetParam().first, GetParam().second);
    const auto tooth = *exerciseTooth(exercise);
    const auto& plan = std::get<PreparationPlan>(exercise.ideal);
    const auto form = CrownForm::make(plan, *tooth, tooth->ownOuter());
    ASSERT_TRUE(form) << form.error().message();
    const SurfacePart* dentin = nullptr;
    for (const LayeredTooth::Layer& layer : tooth->layers()) {
        if (layer.material == test::kDentin) dentin = layer.part.get();
    }
    int enamel = 0, root = 0;
    const auto& points = form->finishLine().points();
    for (const Vec3& place : points) {
        // On the tooth; with enamel there, and none a little deeper than the height below.
        EXPECT_LT(closestPoint(*tooth->ownOuter(), place)->distance, 1e-3);
        enamel += closestPoint(*dentin, place)->distance > 0.05;
        const double highest = std::max({plan.crown->height, plan.crown->plusXHeight, plan.crown->minusXHeight});
        const Vec3 below = place - (highest + 0.6) * plan.outward;
        const Vec3 surface = closestPoint(*tooth->ownOuter(), below)->point;
        root += closestPoint(*dentin, surface)->distance < 0.05;
    }
    EXPECT_GT(enamel, static_cast<int>(0.95 * static_cast<double>(points.size())));
    EXPECT_GT(root, static_cast<int>(0.9 * static_cast<double>(points.size())));
}

INSTANTIATE_TEST_SUITE_P(Patients, CrownOfAnyPatient,
                         testing::Values(std::pair("crown-46", 0U), std::pair("crown-46", 5U),
                                         std::pair("crown-11", 0U), std::pair("crown-11", 5U)));

TEST(CrownForm, MayHaveABuccalWallThatLeansMore) {
    Exercise exercise = ofPatient("crown-46", 0);
    CrownOutline& crown = *std::get<PreparationPlan>(exercise.ideal).crown;
    crown.buccalTaper = 12;
    const auto tooth = *exerciseTooth(exercise);
    const Expected<TriangleMesh> ideal = idealShape(exercise, tooth);
    ASSERT_TRUE(ideal) << ideal.error().message();
    Preparation preparation;
    preparation.original = tooth->ownOuter();
    preparation.prepared = preparation.ideal = std::make_shared<const SurfacePart>(*ideal);
    preparation.mesialX = tooth->toothContext().mesialX;
    const std::vector<MetricResult> results = measureAll(PreparationMeasures(preparation));
    EXPECT_NEAR(valueOf(results, "toc_bl"), crown.taper + 12, 1);
    EXPECT_NEAR(valueOf(results, "toc_md"), 2 * crown.taper, 1);
}

/// Of the crown of an incisor: the cut faces whose normal, and place seen from the finish line, are as asked for.
class CrownOfAnIncisor : public testing::TestWithParam<std::uint32_t> {
protected:
    struct Face {
        Vec3 centre, normal;
        double reduction;  // to the nearest uncut face of the same side, mm
        double area;
    };
    void SetUp() override {
        exercise_ = ofPatient("crown-11", GetParam());
        tooth_ = *exerciseTooth(exercise_);
        plan_ = &std::get<PreparationPlan>(exercise_.ideal);
        const auto form = CrownForm::make(*plan_, *tooth_, tooth_->ownOuter());
        ASSERT_TRUE(form) << form.error().message();
        const Expected<TriangleMesh> ideal = idealShape(exercise_, tooth_);
        ASSERT_TRUE(ideal) << ideal.error().message();
        const CavityWalls walls = cavityWalls(*ideal, *tooth_->ownOuter());
        for (std::size_t i = 0; i < walls.mesh.triangles.size(); ++i) {
            const Vec3 centre = (walls.mesh.corner(i, 0) + walls.mesh.corner(i, 1) + walls.mesh.corner(i, 2)) / 3;
            const Vec3 areaVector = walls.mesh.areaVector(i);
            if (form->finishLine().placeOf(centre).above < 1.5) continue;  // the round inner angle
            const Vec3 normal = areaVector.stableNormalized();
            faces_.push_back({centre, normal, closestPoint(*tooth_->ownOuter(), centre)->distance, areaVector.norm()});
        }
        ASSERT_FALSE(faces_.empty());
        for (const Face& face : faces_) top_ = std::max(top_, face.centre.z());
    }
    Exercise exercise_;
    std::shared_ptr<const LayeredTooth> tooth_;
    const PreparationPlan* plan_ = nullptr;
    std::vector<Face> faces_;
    double top_ = -100;  // of the stump, mm
};

TEST_P(CrownOfAnIncisor, HasTwoLabialPlanes) {
    // Near the middle of the labial face: as steep as the path at the neck, along the uncut face at the edge.
    double cervical = 0, cervicalArea = 0, incisalArea = 0, leanAtEdge = 0;
    for (const Face& face : faces_) {
        if (face.normal.y() < 0.9 || std::abs(face.centre.x()) > 1) continue;
        const double lean = std::asin(face.normal.z()) * 180 / std::numbers::pi;
        if (face.reduction > plan_->crown->buccal + 0.03) {
            cervical += lean * face.area;
            cervicalArea += face.area;
        } else if (face.centre.z() < top_ - 0.5) {
            EXPECT_NEAR(face.reduction, plan_->crown->buccal, 0.05);
            leanAtEdge += lean * face.area;
            incisalArea += face.area;
        }
    }
    ASSERT_GT(cervicalArea, 0.5);
    ASSERT_GT(incisalArea, 0.5);
    EXPECT_NEAR(cervical / cervicalArea, plan_->crown->buccalTaper, 1);
    EXPECT_GT(leanAtEdge / incisalArea, plan_->crown->buccalTaper + 3);
}

TEST_P(CrownOfAnIncisor, FollowsTheLingualFossa) {
    std::vector<double> reductions;
    for (const Face& face : faces_) {
        if (face.normal.y() < -0.5 && std::abs(face.centre.x()) < 1 && face.centre.z() < top_ - 0.5)
            reductions.push_back(face.reduction);
    }
    ASSERT_GT(reductions.size(), 50U);
    std::ranges::sort(reductions);
    EXPECT_GT(reductions.front(), plan_->crown->lingual - 0.05);
    EXPECT_NEAR(reductions[reductions.size() / 2], plan_->crown->lingual, 0.05);
}

// The ends of the faces that the fossa follows must not show in the stump.
TEST_P(CrownOfAnIncisor, IsSmoothWhereTheLingualWallMeetsTheFossa) {
    const auto form = CrownForm::make(*plan_, *tooth_, tooth_->ownOuter());
    ASSERT_TRUE(form) << form.error().message();
    constexpr double kStep = 0.1, kHalf = 1.2,
                     kRough = 0.015;  // mm: a circle of 0.7 mm departs so far from its tangent
    double roughest = 0;
    for (double above = 0.65; above < 1.05; above += 0.05) {
        const double z = form->finishLine().lowest() + above;
        std::vector<double> wall;  // y of the stump's lingual side, from distal to mesial
        for (double x = -kHalf; x <= kHalf; x += kStep) {
            double removed = -6, stands = 1;
            while (stands - removed > 1e-4) {
                const double middle = (removed + stands) / 2;
                (form->depthAt(Vec3(x, middle, z)).value > 0 ? removed : stands) = middle;
            }
            wall.push_back(stands);
        }
        for (std::size_t i = 1; i + 1 < wall.size(); ++i) {
            roughest = std::max(roughest, std::abs(wall[i - 1] - 2 * wall[i] + wall[i + 1]));
        }
    }
    EXPECT_LT(roughest, kRough);
}

// A jump would be a crease in the stump.
TEST_P(CrownOfAnIncisor, HasAFinishLineWhoseHeightDoesNotJumpOverTheShoulder) {
    const auto form = CrownForm::make(*plan_, *tooth_, tooth_->ownOuter());
    ASSERT_TRUE(form) << form.error().message();
    const FinishLine& line = form->finishLine();
    constexpr double kStep = 0.03, kDeep = 1.2, kSteepest = 2;  // mm; mm for each mm
    double steepest = 0, wrongest = 0;
    for (double x = -4; x < 4; x += kStep) {
        for (double y = -4; y < 4; y += kStep) {
            const Vec3 place = line.middle() + x * line.across() + y * line.aside();
            const FinishLine::Place at = line.placeOf(place);
            if (at.inside < 0 || at.inside > kDeep) continue;
            for (const Vec3& step : {line.across(), line.aside()}) {
                const double change = line.placeOf(place + kStep * step).above - at.above;
                steepest = std::max(steepest, std::abs(change) / kStep);
                constexpr double kLittle = 1e-5;  // mm
                const double slope = (line.placeOf(place + kLittle * step).above - at.above) / kLittle;
                wrongest = std::max(wrongest, std::abs(slope - at.upward.dot(step)));
            }
        }
    }
    EXPECT_LT(steepest, kSteepest);
    EXPECT_LT(wrongest, 0.15);  // most where another point of the line becomes the nearest
}

TEST_P(CrownOfAnIncisor, LeavesDentinOverThePulp) {
    for (const LayeredTooth::Layer& layer : tooth_->layers()) {
        if (layer.material != test::kPulp) continue;
        for (const Face& face : faces_) EXPECT_GT(closestPoint(*layer.part, face.centre)->distance, 0.2);
    }
}

INSTANTIATE_TEST_SUITE_P(Patients, CrownOfAnIncisor, testing::Values(0U, 5U));

TEST(CrownForm, OfAToothWithoutLayersNeedsItsCervicalLine) {
    const Exercise exercise = ofPatient("crown-46", 0);
    const auto built = *exerciseTooth(exercise);
    const auto bare = LayeredTooth::make(built->ownOuter()->mesh(), {});
    ASSERT_TRUE(bare);
    PreparationPlan plan = std::get<PreparationPlan>(exercise.ideal);
    const auto none = CrownForm::make(plan, *bare, bare->ownOuter());
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().message().find("cervical"), std::string::npos);
    plan.crown->cervical = 0.4;
    const auto given = CrownForm::make(plan, *bare, bare->ownOuter());
    ASSERT_TRUE(given);
    EXPECT_NEAR(given->finishLine().lowest(), 0.4 + plan.crown->height, 0.05);
    plan.crown->cervical = 60;
    EXPECT_FALSE(CrownForm::make(plan, *bare, bare->ownOuter()));
}

}  // namespace
}  // namespace tactooth
