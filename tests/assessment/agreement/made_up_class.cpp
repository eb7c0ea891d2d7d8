// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/agreement/made_up_class.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "assessment/agreement/agreement_random.h"
#include "assessment/agreement/range_widening.h"
#include "assessment/rubric/rubric_file.h"
#include "geometry/util/number_text.h"

namespace tactooth::test {

Rubric madeUpRubric(const std::array<double, 4>& weights, double widening, std::string_view more) {
    const std::array<std::string, 4> criteria = {
        "metric = \"floor_depth_median\"\nideal = [1.5, 2]\ncorrect = [1.2, 2.3]\nzero = [0.8, 2.7]\n",
        "metric = \"over_max\"\nideal = [0, 0.1]\nacceptable = [0, 0.2]\ncorrect = [0, 0.4]\nzero = [0, 1]\n",
        "metric = \"floor_flatness\"\nideal = [0, 0.1]\ncorrect = [0, 0.25]\nzero = [0, 0.4]\n",
        "metric = \"wall_angle_b\"\nideal = [1, 8]\nacceptable = [-1, 10]\ncorrect = [-4, 13]\nzero = [-10, 20]\n"};
    std::string text = "name = \"Made up\"\n";
    for (std::size_t i = 0; i < criteria.size(); ++i) {
        text += "[[criterion]]\nweight = " + numberText(weights[i]) + "\n" + criteria[i];
    }
    auto rubric = parseRubric(text.append(more), "made_up.toml");
    EXPECT_TRUE(rubric) << rubric.error().message();
    if (widening != 1) rubric->criteria[0].levels = widened(rubric->criteria[0].levels, widening);
    return std::move(*rubric);
}

void setResult(std::vector<MetricResult>& results, std::string_view id, std::optional<double> value) {
    const auto found = std::ranges::find(results, findPreparationMetric(id), &MetricResult::metric);
    ASSERT_NE(found, results.end());
    found->measured.value = value;
}

std::vector<MetricResult> madeUpResults(SeededRandom& random) {
    std::vector<MetricResult> results;
    for (const PreparationMetric& metric : preparationMetrics()) results.push_back({&metric, {}});
    setResult(results, "floor_depth_median", 1.75 + 0.4 * normal(random));
    setResult(results, "over_max", 0.3 * std::abs(normal(random)));
    setResult(results, "floor_flatness", 0.2 * std::abs(normal(random)));
    setResult(results, "wall_angle_b", 5 + 7 * normal(random));
    return results;
}

std::vector<MeasuredWork> madeUpWorks(std::size_t students, std::size_t each, std::uint64_t seed) {
    SeededRandom random(seed);
    std::vector<MeasuredWork> works;
    for (std::size_t student = 0; student < students; ++student) {
        for (std::size_t work = 0; work < each; ++work) {
            const std::string name = "student " + std::to_string(student);
            works.push_back({name + ", work " + std::to_string(work), name, madeUpResults(random)});
        }
    }
    return works;
}

std::vector<TeacherMark> marksBy(const Rubric& rubric, const std::vector<MeasuredWork>& works, std::size_t teachers,
                                 double error, std::uint64_t seed) {
    SeededRandom random(seed);
    std::vector<TeacherMark> marks;
    for (const MeasuredWork& work : works) {
        const double mark = markOf(rubric, work.results).value.value_or(0);
        for (std::size_t teacher = 0; teacher < teachers; ++teacher) {
            const double given = std::round(std::clamp(mark + error * normal(random), 0.0, 100.0));
            marks.push_back({work.id, work.student, "teacher " + std::to_string(teacher), given});
        }
    }
    return marks;
}

}  // namespace tactooth::test
