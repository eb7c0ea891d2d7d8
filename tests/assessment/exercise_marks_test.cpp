// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// What the rubric of each built-in exercise makes of work that is known to be good or bad.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "assessment/cavity_walls.h"
#include "assessment/crown/crown_form.h"
#include "assessment/crown/removed_body.h"
#include "assessment/exercise_scene.h"
#include "assessment/ideal_shape.h"
#include "assessment/rubric/rubric_file.h"
#include "assessment/study/hand_habits.h"
#include "collision/bvh/closest_point.h"
#include "session/simulation/cut_model.h"
#include "support/materials.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

using test::ExerciseScene;

/// Signed distance to a closed surface, with its gradient: positive outside.
RemovedBody::Depth outsideOf(const SurfacePart& part, const Vec3& place) {
    const double distance = signedDistance(part, place);
    const Vec3 from = place - closestPoint(part, place)->point;
    return {distance, from.norm() > 1e-9 ? Vec3((distance < 0 ? -1 : 1) * from.normalized()) : Vec3(Vec3::UnitZ())};
}

/// Around all that an ideal shape lacks of the uncut tooth.
Box3 boxOfWork(const TriangleMesh& ideal, const SurfacePart& outer) {
    Box3 box;
    const SurfacePart shape(ideal);
    for (const Vec3f& vertex : cavityWalls(ideal, outer).mesh.vertices) box.extend(vertex.cast<double>());
    for (const Vec3f& vertex : outer.mesh().vertices) {
        if (signedDistance(shape, vertex.cast<double>()) > 0.05) box.extend(vertex.cast<double>());
    }
    return {box.min() - Vec3::Constant(0.5), box.max() + Vec3::Constant(0.5)};
}

/// A crown preparation by an unsteady hand: it strays in waves of a bur's width.
class UnsteadyWork : public RemovedBody {
public:
    /// `height`: of each wave, mm; as far as it strays in each direction, RMS
    UnsteadyWork(CrownForm meant, double height) : meant_(std::move(meant)), height_(height) {}

    [[nodiscard]] Depth depthAt(const Vec3& place) const override {
        const Vec3 number(2 * std::numbers::pi / 1.3, 2 * std::numbers::pi / 1.7, 2 * std::numbers::pi / 1.5);  // 1/mm
        const Vec3 phase = number.cwiseProduct(place);
        const Vec3 aside(std::sin(phase.y() + 1) + std::sin(phase.z() + 2), std::sin(phase.x()) + std::sin(phase.z()),
                         std::sin(phase.x() + 3) + std::sin(phase.y() + 4));
        return meant_.depthAt(place + height_ * aside);
    }
    [[nodiscard]] Box3 box() const override { return meant_.box(); }

private:
    CrownForm meant_;
    double height_;
};

/// Nearly the ideal preparation, and what a real bur does at the pulp: a hole of 1 mm down into it, or a roof of
/// dentin that stays over it.
class WorkAtThePulp : public RemovedBody {
public:
    WorkAtThePulp(const ExerciseScene& scene, const SurfacePart& pulp, const Vec3& outward)
        : ideal_(*scene.ideal), pulp_(pulp), outward_(outward) {
        const CavityWalls walls = cavityWalls(*scene.ideal, *scene.tooth->ownOuter());
        const SurfacePart cut(walls.mesh);
        double least = 1e9;
        for (const Vec3f& vertex : pulp.mesh().vertices) {
            const Vec3 place = vertex.cast<double>();
            const double distance = closestPoint(cut, place)->distance;
            if (distance >= least) continue;
            least = distance;
            horn_ = place;
        }
        const Vec3 over = closestPoint(cut, horn_)->point;
        if (least > 0.1) outward_ = (over - horn_).normalized();
        box_ = boxOfWork(*scene.ideal, *scene.tooth->ownOuter());
        box_.extend(Vec3(horn_ - Vec3::Constant(0.5)));
        box_.extend(Vec3(horn_ + Vec3::Constant(0.5)));
    }

    enum class At { NotYet, Hole, Roof };
    At at = At::NotYet;

    [[nodiscard]] Depth depthAt(const Vec3& place) const override {
        constexpr double kLeft = 0.03;  // mm: clear of the uncut surface
        Depth depth = outsideOf(ideal_, place);
        depth.value -= kLeft;
        if (at == At::Hole) {
            constexpr double kRadius = 0.5, kDeep = 0.3, kLong = 4;  // mm
            const double along = std::clamp(outward_.dot(place - horn_), -kDeep, kLong);
            const Vec3 from = place - horn_ - along * outward_;
            const double inside = kRadius - from.norm();
            if (inside > depth.value) depth = {inside, from.norm() > 0 ? Vec3(-from.normalized()) : outward_};
        }
        if (at == At::Roof) {
            constexpr double kRoof = 0.3;  // mm of dentin
            Depth over = outsideOf(pulp_, place);
            over.value -= kRoof;
            if (over.value < depth.value) depth = over;
        }
        return depth;
    }
    [[nodiscard]] Box3 box() const override { return box_; }

private:
    SurfacePart ideal_;
    const SurfacePart& pulp_;
    Vec3 outward_, horn_ = Vec3::Zero();
    Box3 box_;
};

class EachRubric : public ::testing::TestWithParam<std::shared_ptr<const Exercise>> {
protected:
    void SetUp() override {
        ASSERT_TRUE(scene_.ideal) << scene_.ideal.error().message();
        const auto found = findRubric(exercise_.rubric.empty() ? std::string(kUsualRubric) : exercise_.rubric);
        ASSERT_TRUE(found) << found.error().message();
        rubric_ = *found;
    }

    [[nodiscard]] std::vector<MetricResult> measure(const TriangleMesh& work) const {
        return measure(work, scene_.neighbours);
    }
    [[nodiscard]] std::vector<MetricResult> measure(const TriangleMesh& work,
                                                    std::shared_ptr<const SurfacePart> neighbours) const {
        Preparation preparation = scene_.preparation(exercise_);
        preparation.neighbours = std::move(neighbours);
        preparation.prepared = std::make_shared<const SurfacePart>(work);
        return measureAll(PreparationMeasures(preparation));
    }

    [[nodiscard]] TriangleMesh cut(const RemovedBody& body) const {
        CutModel piece(scene_.tooth, 0.05);
        piece.adopt(cutFieldsOf(body, *scene_.tooth->ownOuter(), piece.volume().lattice()), {});
        return asReadFromFile(*piece.surface());
    }

    const Exercise& exercise_ = *GetParam();
    const ExerciseScene& scene_ = ExerciseScene::of(exercise_);
    Rubric rubric_;
};

double valueIn(const std::vector<MetricResult>& results, std::string_view id) {
    const auto found = std::ranges::find(results, id, [](const MetricResult& each) { return each.metric->id; });
    return found != results.end() ? found->measured.value.value_or(-1) : -1;
}

TEST_P(EachRubric, PassesAnExpert) {
    const std::vector<MetricResult> expert = measure(*scene_.ideal);
    const Mark mark = markOf(rubric_, expert);
    for (const CriterionScore& each : mark.criteria) {
        if (each.lost > 0.5)
            std::printf("  %s %s: %.2f costs %.1f\n", exercise_.id.c_str(), each.criterion->title.c_str(),
                        each.measured.value.value_or(-1), each.lost);
    }
    std::printf("  %s: %.1f\n", exercise_.id.c_str(), mark.value.value_or(-1));
    EXPECT_GE(mark.value.value_or(-1), 90);
    EXPECT_TRUE(mark.passes);
    EXPECT_EQ(valueIn(expert, "pulp_open"), exercise_.opensPulp() ? 1 : 0);
}

/// The ideal box stands clear of the tooth beside, at its gingival margin by about the 0.5 mm of textbooks.
TEST_P(EachRubric, OpensTheContactOfABox) {
    const auto* plan = std::get_if<PreparationPlan>(&exercise_.ideal);
    if (exercise_.group != ExerciseGroup::ClassTwo) return;
    ASSERT_NE(plan, nullptr);
    const std::vector<MetricResult> expert = measure(*scene_.ideal);
    for (const char* id : {"contact_gap_gingival", "contact_gap_buccal", "contact_gap_lingual"}) {
        std::printf("  %s %s: %.3f\n", exercise_.id.c_str(), id, valueIn(expert, id));
        EXPECT_GE(valueIn(expert, id), 0.1) << id;
        EXPECT_LE(valueIn(expert, id), 0.8) << id;
    }
    EXPECT_NEAR(valueIn(expert, "contact_gap_gingival"), 0.5, 0.2);
    const std::vector<MetricResult> uncut = measure(scene_.tooth->ownOuter()->mesh());
    for (const char* id : {"contact_gap_gingival", "contact_gap_buccal", "contact_gap_lingual"})
        EXPECT_EQ(valueIn(uncut, id), 0) << id;
}

TEST_P(EachRubric, FailsWhoDrillsIntoThePulpOrDoesNotFindIt) {
    const SurfacePart* pulp = nullptr;
    for (const LayeredTooth::Layer& layer : scene_.tooth->layers()) {
        if (layer.material == test::kPulp) pulp = layer.part.get();
    }
    ASSERT_NE(pulp, nullptr);
    WorkAtThePulp work(scene_, *pulp, std::get<PreparationPlan>(exercise_.ideal).outward);
    const std::vector<MetricResult> before = measure(cut(work));
    EXPECT_EQ(valueIn(before, "pulp_open"), exercise_.opensPulp() ? 1 : 0);
    EXPECT_TRUE(markOf(rubric_, before).passes) << markOf(rubric_, before).value.value_or(-1);
    work.at = exercise_.opensPulp() ? WorkAtThePulp::At::Roof : WorkAtThePulp::At::Hole;
    const std::vector<MetricResult> after = measure(cut(work));
    EXPECT_EQ(valueIn(after, "pulp_open"), exercise_.opensPulp() ? 0 : 1);
    EXPECT_FALSE(markOf(rubric_, after).passes) << markOf(rubric_, after).value.value_or(-1);
}

TEST_P(EachRubric, GivesNothingForNothing) {
    const Mark mark = markOf(rubric_, measure(scene_.tooth->ownOuter()->mesh()));
    EXPECT_EQ(mark.value.value_or(-1), 0);
}

TEST_P(EachRubric, FailsWhoRemovesEverything) {
    const Vec3 root = scene_.tooth->ownBox().min() + Vec3(0, 0, 2);
    const Vec3 middle(0, 0, root.z());
    const Mark mark = markOf(rubric_, measure(test::box(middle - Vec3::Constant(0.2), middle + Vec3::Constant(0.2))));
    EXPECT_FALSE(mark.passes);
}

/// As students have been measured: walls of 22 to 25 degrees, a shoulder of 0.86 mm and a chamfer of 0.7 mm, 0.5 mm too
/// much off the end (Quintessence Int. 35, 2004); a line 0.4 mm higher than asked for, and a hand as uneven as a
/// student's of `tactooth study`. The studies do not say how often the tooth beside was touched, so it is not known
/// here.
TEST_P(EachRubric, PassesACarefulBeginnersCrownButDoesNotPraiseIt) {
    const auto* plan = std::get_if<PreparationPlan>(&exercise_.ideal);
    if (plan == nullptr || !plan->crown) return;
    Exercise beginners = exercise_;
    CrownOutline& crown = *std::get<PreparationPlan>(beginners.ideal).crown;
    crown.taper = crown.buccalTaper = 12;
    crown.width *= crown.tipRadius >= crown.width ? 1.4 : 0.86;
    crown.occlusal += 0.5;
    crown.functional += 0.5;
    for (double CrownOutline::*height :
         {&CrownOutline::height, &CrownOutline::plusXHeight, &CrownOutline::minusXHeight})
        crown.*height += 0.4;
    auto meant = CrownForm::make(std::get<PreparationPlan>(beginners.ideal), *scene_.tooth, scene_.tooth->ownOuter());
    ASSERT_TRUE(meant) << meant.error().message();
    const std::vector<MetricResult> work =
        measure(cut(UnsteadyWork(std::move(*meant), usualHabits(HandLevel::Student).uneven)), nullptr);
    // Uneven walls have an angle, too. The cheek's and the tongue's follow the planes of the tooth besides.
    EXPECT_NEAR(valueIn(work, "toc_md"), 2 * crown.taper, 6);
    EXPECT_GT(valueIn(work, "toc_bl"), 0);
    const Mark mark = markOf(rubric_, work);
    for (const CriterionScore& each : mark.criteria)
        std::printf("  %s: %.2f costs %.1f\n", each.criterion->title.c_str(), each.measured.value.value_or(-1),
                    each.lost);
    std::printf("  %s, careful beginner: %.1f\n", exercise_.id.c_str(), mark.value.value_or(-1));
    EXPECT_GE(mark.value.value_or(-1), 60);
    EXPECT_LE(mark.value.value_or(-1), 85);
}

std::string idOfRubric(const ::testing::TestParamInfo<std::shared_ptr<const Exercise>>& one) {
    std::string name = one.param->id;
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Exercises, EachRubric, ::testing::ValuesIn(exercises().begin(), exercises().end()),
                         idOfRubric);

}  // namespace
}  // namespace tactooth
