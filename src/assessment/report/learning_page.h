// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "assessment/agreement/learning_curve.h"
#include "assessment/report/stored_report.h"

namespace tactooth {

/// The criteria by which an exercise counts as learnt.
struct LearningTest {
    CusumRates rates;
    CusumPlan cusum;
    double adequate;  ///< rate of failures of a student who can do it, 0..1
    LearningPlan learning;
};

/// The trials of one exercise by one student.
struct StudentLearning {
    std::string name;                  ///< empty: not known
    std::vector<StoredReport> trials;  ///< in the order of time, comparable, at least one
    std::vector<CusumPoint> cusum;     ///< a point for each
    LearningCurve curve;

    /// The last decision of the CUSUM, and its trial, from 0; nothing without one.
    [[nodiscard]] std::optional<std::size_t> decidedAt() const;
    [[nodiscard]] std::size_t passed() const;
};

/// One for each student and each exercise and rubric, by name. A work that was assessed several times counts once.
/// `reports`: in the order of time.
[[nodiscard]] std::vector<StudentLearning> learningOf(const std::vector<StoredReport>& reports,
                                                      const LearningTest& test);

/// What the trials show, in two sentences: by LC-CUSUM and by CUSUM.
[[nodiscard]] std::vector<std::string> learningTexts(const StudentLearning& student, const LearningTest& test,
                                                     Language language);

/// The two charts of each student, with the parameters. One page without other files or scripts.
[[nodiscard]] std::string learningHtml(const std::vector<StudentLearning>& students, const LearningTest& test,
                                       Language language);
/// The same for programs; docs/assessment.md describes it.
[[nodiscard]] std::string learningJson(const std::vector<StudentLearning>& students, const LearningTest& test);

}  // namespace tactooth
