// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/rubric/exercise_rubric.h"

#include <algorithm>

#include "assessment/messages.h"
#include "assessment/rubric/rubric_file.h"

namespace tactooth {
namespace {

/// mm^3: a nick of half a millimetre is a critical error, the roughness of a surface is none.
constexpr std::array<LevelRanges::Range, 4> kForbidden = {{{0, 0}, {0, 0.02}, {0, 0.05}, {0, 0.1}}};

}  // namespace

Expected<Rubric> rubricOf(const Exercise& exercise, const std::string& other) {
    const std::string& own = exercise.rubric.empty() ? std::string(kUsualRubric) : exercise.rubric;
    Expected<Rubric> rubric = findRubric(other.empty() ? own : other);
    if (!rubric || exercise.forbidden.empty()) return rubric;
    const PreparationMetric* metric = findPreparationMetric("forbidden_volume");
    if (std::ranges::find(rubric->criteria, metric, &Criterion::metric) != rubric->criteria.end()) return rubric;
    rubric->criteria.push_back({.title = std::string(msg::kForbiddenCriterion.english),
                                .metric = metric,
                                .weight = 0,
                                .levels = LevelRanges(kForbidden),
                                .critical = true,
                                .limitsMark = false,
                                .japaneseTitle = std::string(msg::kForbiddenCriterion.japanese)});
    return rubric;
}

}  // namespace tactooth
