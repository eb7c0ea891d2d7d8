// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/rubric/exercise_rubric.h"

#include <gtest/gtest.h>

#include "assessment/rubric/rubric_file.h"

namespace tactooth {
namespace {

TEST(ExerciseRubric, IsTheGivenOneThenTheExercisesOwnThenTheUsualOne) {
    Exercise exercise;
    EXPECT_EQ(rubricText(*rubricOf(exercise)), rubricText(*findRubric(std::string(kUsualRubric))));
    exercise.rubric = "class-1";
    EXPECT_EQ(rubricText(*rubricOf(exercise)), rubricText(*findRubric("class-1")));
    EXPECT_EQ(rubricText(*rubricOf(exercise, "class-5")), rubricText(*findRubric("class-5")));
    EXPECT_FALSE(rubricOf(exercise, "class-9"));
}

TEST(ExerciseRubric, MakesACutInAForbiddenZoneACriticalError) {
    Exercise exercise;
    exercise.rubric = "class-1";
    exercise.forbidden = {{.corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, .outward = Vec3::UnitZ()}};
    const Rubric rubric = *rubricOf(exercise);
    const auto markAt = [&](double volume) {
        std::vector<MetricResult> results;
        for (const PreparationMetric& metric : preparationMetrics()) {
            for (const Criterion& each : rubric.criteria) {
                if (each.metric != &metric) continue;
                const bool isZone = metric.id == "forbidden_volume";
                results.push_back({&metric, Measured::of(isZone ? volume : each.levels.ranges()[0].low)});
            }
        }
        return markOf(rubric, results);
    };
    EXPECT_EQ(markAt(0).value, 100);
    EXPECT_EQ(markAt(0.01).value, 100);  // roughness
    EXPECT_EQ(markAt(0.1).value, rubric.criticalMark);
    EXPECT_FALSE(markAt(0.1).passes);
}

}  // namespace
}  // namespace tactooth
