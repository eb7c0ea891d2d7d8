// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "assessment/study/study.h"

namespace tactooth {

/// The results of a study, for files that people and programs read.
struct StudyReport {
    std::string exercise, japaneseExercise;  ///< names
    const Rubric* rubric = nullptr;          ///< not null
    std::size_t handsOfLevel = 0;
    std::uint64_t seed = 0;
    std::vector<StudyTrial> trials;
    std::string program;  ///< version and commit
};

// docs/assessment.md describes the forms. Each begins by saying that the hands are synthetic.

/// One page without other files or scripts.
[[nodiscard]] std::string studyHtml(const StudyReport& report, Language language);
/// A row for each hand: its level, its habits, its mark and all metrics.
[[nodiscard]] std::string studyCsv(const StudyReport& report);
[[nodiscard]] std::string studyJson(const StudyReport& report);

/// "Passed: ..." or what is not: one sentence.
[[nodiscard]] std::string studyResultText(const StudyReport& report, Language language);

}  // namespace tactooth
