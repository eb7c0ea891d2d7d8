// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/exercise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "assessment/cavity_metrics.h"
#include "assessment/cavity_walls.h"
#include "assessment/exercise_scene.h"
#include "assessment/rubric/rubric_file.h"
#include "collision/bvh/closest_point.h"
#include "geometry/mesh/mesh_report.h"
#include "instruments/bur_catalogue.h"
#include "support/materials.h"

namespace tactooth {
namespace {

using test::ExerciseScene;

const SurfacePart* layerOf(const LayeredTooth& tooth, MaterialId material) {
    for (const LayeredTooth::Layer& layer : tooth.layers()) {
        if (layer.material == material) return layer.part.get();
    }
    return nullptr;
}

/// The largest distance of a layer beyond `target`, mm: positive where the target has lost some of the layer.
double mostOutside(const SurfacePart& layer, const SurfacePart& target) {
    double most = -1e9;
    for (const Vec3f& vertex : layer.mesh().vertices)
        most = std::max(most, signedDistance(target, vertex.cast<double>()));
    return most;
}

class EachExercise : public ::testing::TestWithParam<std::shared_ptr<const Exercise>> {
protected:
    const Exercise& exercise_ = *GetParam();
};

/// All about the shape in one test, so that a run of one shard makes it once.
TEST_P(EachExercise, HasAClosedIdealShapeThatLeavesThePulpCoveredAndRemovesTheDecay) {
    const ExerciseScene& scene = ExerciseScene::of(exercise_);
    ASSERT_TRUE(scene.ideal) << scene.ideal.error().message();
    const MeshReport report = reportOn(*scene.ideal);
    ASSERT_TRUE(report.watertight());
    const auto target = std::make_shared<const SurfacePart>(*scene.ideal);
    CavityMetrics metrics(target, *scene.tooth->ownOuter());
    Surface whole;
    whole.base = scene.tooth->ownOuter();
    const double volume = metrics.of(whole, 0).planned;
    EXPECT_GT(volume, 0.5);
    const double most = exercise_.group == ExerciseGroup::Crown ? 250 : exercise_.opensPulp() ? 100 : 30;
    EXPECT_LT(volume, most);
    EXPECT_NEAR(volume, *reportOn(whole.base->mesh()).volume() - *report.volume(), 0.03 * volume);

    constexpr double kMinDentin = 0.5;  // mm
    const SurfacePart* pulp = layerOf(*scene.tooth, test::kPulp);
    ASSERT_NE(pulp, nullptr);
    if (exercise_.opensPulp()) {
        EXPECT_GT(mostOutside(*pulp, *target), 0.5);
    } else {
        EXPECT_GT(*leastToPulp(cavityWalls(*scene.ideal, *whole.base), *scene.tooth), kMinDentin);
        const double atTheRoots = mostOutside(*pulp, *whole.base);  // of 16: 0.46 mm inside the tooth
        EXPECT_LT(mostOutside(*pulp, *target), std::max(-kMinDentin, atTheRoots + 1e-3));
    }
    const SurfacePart* decay = layerOf(*scene.tooth, test::kCaries);
    EXPECT_EQ(decay != nullptr, exercise_.group == ExerciseGroup::Caries);
    if (decay == nullptr) return;
    for (const Vec3f& vertex : decay->mesh().vertices) {
        ASSERT_GT(signedDistance(*target, vertex.cast<double>()), -0.1) << "decay is left";
    }
}

TEST_P(EachExercise, SaysInBothLanguagesWhatIsToBeDoneAndHow) {
    for (const Language language : {Language::English, Language::Japanese}) {
        const ExerciseWords words = exercise_.words(language);
        EXPECT_FALSE(words.name.empty());
        EXPECT_FALSE(words.task.empty());
        EXPECT_FALSE(words.brief.empty());
    }
    EXPECT_NE(exercise_.words(Language::English).task, exercise_.words(Language::Japanese).task);
    EXPECT_NE(exercise_.group, ExerciseGroup::Own);
    EXPECT_TRUE(exercise_.minutes);
    EXPECT_TRUE(findRubric(exercise_.rubric.empty() ? std::string(kUsualRubric) : exercise_.rubric));
    EXPECT_TRUE(findBur(std::get<std::string>(exercise_.bur)));
}

std::string idOf(const ::testing::TestParamInfo<std::shared_ptr<const Exercise>>& one) {
    std::string name = one.param->id;
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Exercises, EachExercise, ::testing::ValuesIn(exercises().begin(), exercises().end()), idOf);

TEST(Exercises, HaveDifferentNamesAndAreOrderedByGroupThenByLevel) {
    std::set<std::string> names, ids;
    for (const auto& one : exercises()) {
        names.insert(one->name);
        ids.insert(one->id);
        EXPECT_EQ(builtinExercise(one->id), one);
    }
    EXPECT_EQ(names.size(), exercises().size());
    EXPECT_EQ(ids.size(), exercises().size());
    EXPECT_TRUE(
        std::ranges::is_sorted(exercises(), {}, [](const auto& one) { return std::pair(one->group, one->level); }));
    EXPECT_EQ(builtinExercise("class-9"), nullptr);
}

/// The same exercise on the tooth of another patient.
Exercise ofPatient(const char* id, std::uint32_t seed) {
    Exercise exercise = *builtinExercise(id);
    std::get<ToothRequest>(exercise.tooth).seed = seed;
    return exercise;
}

TEST(FissureOutline, FollowsTheFissureOfAnyPatient) {
    for (const char* id : {"class-1-36", "class-1-14", "class-1-16"}) {
        for (const std::uint32_t seed : {0U, 1U}) {
            const Exercise exercise = ofPatient(id, seed);
            const auto tooth = *exerciseTooth(exercise);
            const auto& plan = std::get<PreparationPlan>(exercise.ideal);
            const std::shared_ptr<const SurfacePart> outer = tooth->ownOuter();
            const std::vector<BurPath> paths = burPaths(plan, *tooth, outer);
            ASSERT_FALSE(paths.empty());
            // A ball of 1.2 mm radius that rolls into the valley is lower than one on the slopes beside it.
            const auto restsAt = [&](const Vec3& place) {
                constexpr double kRadius = 1.2;
                double low = 0, high = 20;
                while (high - low > 0.01) {
                    const double middle = (low + high) / 2;
                    const bool isFree = signedDistance(*outer, Vec3(place.x(), place.y(), middle)) > kRadius;
                    (isFree ? high : low) = middle;
                }
                return high;
            };
            double sum = 0;
            int count = 0;
            for (std::size_t i = 0; i < paths.front().places.size(); i += 4) {
                const Vec3& place = paths.front().places[i];
                sum += std::min(restsAt(place + Vec3(0, 1.2, 0)), restsAt(place - Vec3(0, 1.2, 0))) - restsAt(place);
                ++count;
            }
            EXPECT_GT(sum / count, 0.2) << id << " of patient " << seed;
        }
    }
}

TEST(FissureOutline, LeavesTheMarginalRidgesThatAreAskedFor) {
    const Exercise exercise = ofPatient("class-1-36", 3);
    const auto tooth = *exerciseTooth(exercise);
    const auto& plan = std::get<PreparationPlan>(exercise.ideal);
    const std::vector<Vec3> path = burPaths(plan, *tooth, tooth->ownOuter()).front().places;
    const Box3 box = tooth->ownBox();
    const auto [first, last] = std::ranges::minmax(path, {}, [](const Vec3& place) { return place.x(); });
    EXPECT_NEAR(first.x() - plan.fissure->burRadius - box.min().x(), 2.1, 0.05);
    EXPECT_NEAR(box.max().x() - last.x() - plan.fissure->burRadius, 2.1, 0.05);
}

TEST(ProximalCaries, IsClearedUpToTheOutsideInTheToothOfAnyPatient) {
    for (const std::uint32_t seed : {0U, 1U, 2U, 3U}) {
        const Exercise exercise = ofPatient("caries-45", seed);
        const auto tooth = *exerciseTooth(exercise);
        const Expected<TriangleMesh> ideal = idealShape(exercise, tooth);
        ASSERT_TRUE(ideal) << ideal.error().message();
        EXPECT_TRUE(reportOn(*ideal).watertight()) << "patient " << seed;
        EXPECT_GT(*leastToPulp(cavityWalls(*ideal, *tooth->ownOuter()), *tooth), 0.5) << "patient " << seed;
        const SurfacePart target(*ideal);
        const auto& plan = std::get<PreparationPlan>(exercise.ideal);
        double left = 0;  // mm: how deep in the ideal shape a place lies that should be free
        for (const Vec3f& vertex : layerOf(*tooth, test::kCaries)->mesh().vertices) {
            for (double along = 0; along < 3; along += 0.25) {
                const Vec3 place = vertex.cast<double>() + along * *plan.body->openTo;
                left = std::max(left, -signedDistance(target, place));
                left = std::max(left, -signedDistance(target, place + 2 * plan.outward));
            }
        }
        EXPECT_LT(left, 0.1) << "patient " << seed;
    }
}

/// The wall between a cavity and the side to which it is not open stays.
TEST(ProximalCaries, KeepsAShellWhereTheCavityIsNotOpen) {
    Exercise exercise = ofPatient("caries-45", 0);
    auto& body = *std::get<PreparationPlan>(exercise.ideal).body;
    const Vec3 toSide = *body.openTo;
    const auto tooth = *exerciseTooth(exercise);
    const SurfacePart open(*idealShape(exercise, tooth));
    body.openTo.reset();
    const SurfacePart closed(*idealShape(exercise, tooth));
    const SurfacePart& outer = *tooth->ownOuter();
    double inClosed = 0, inOpen = 0;  // mm: how far places in the skin of that side lie inside the shapes
    for (const Vec3f& vertex : outer.mesh().vertices) {
        const Vec3 place = vertex.cast<double>() - 0.1 * toSide;
        if (signedDistance(outer, place) > -0.05 || place.z() < 4 || place.z() > 6 || std::abs(place.y()) > 0.5)
            continue;
        if (toSide.dot(place) < 2) continue;
        inClosed = std::max(inClosed, -signedDistance(closed, place));
        inOpen = std::max(inOpen, -signedDistance(open, place));
    }
    EXPECT_GT(inClosed, 0.05);
    EXPECT_EQ(inOpen, 0);
}

}  // namespace
}  // namespace tactooth
