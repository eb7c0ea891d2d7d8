// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "assessment/agreement/calibration.h"
#include "assessment/agreement/seeded_random.h"

namespace tactooth::test {

/// A rubric with these weights for depth, over-preparation, flatness and a wall, and ranges that are `widening` times
/// as wide for the depth. `more` are further criteria.
[[nodiscard]] Rubric madeUpRubric(const std::array<double, 4>& weights, double widening = 1,
                                  std::string_view more = {});

/// Results of all metrics: random values about what madeUpRubric asks for, and for all others none.
[[nodiscard]] std::vector<MetricResult> madeUpResults(SeededRandom& random);
/// Sets the value of one metric, or takes it away.
void setResult(std::vector<MetricResult>& results, std::string_view id, std::optional<double> value);

/// Students with some works each.
[[nodiscard]] std::vector<MeasuredWork> madeUpWorks(std::size_t students, std::size_t each, std::uint64_t seed);

/// Teachers who mark by a rubric, with a normal error of this standard deviation.
[[nodiscard]] std::vector<TeacherMark> marksBy(const Rubric& rubric, const std::vector<MeasuredWork>& works,
                                               std::size_t teachers, double error, std::uint64_t seed);

}  // namespace tactooth::test
