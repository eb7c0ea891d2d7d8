// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "assessment/report/trial_trend.h"
#include "assessment/rubric/rubric.h"
#include "geometry/util/message.h"

namespace tactooth {

/// One work of a class.
struct ClassRow {
    std::string student = {};       ///< name of the folder with the student's works; empty: this is the only one
    std::string work;               ///< name of the file
    std::string folder;             ///< of its report, beside the table or in the folder of the student
    std::optional<Mark> mark = {};  ///< by the rubric of the table; nothing: it could not be assessed
    Message fault = {};             ///< why not
};

/// One row for each work: mark, result, and the value and the score of each criterion.
[[nodiscard]] std::string classCsv(const std::vector<ClassRow>& rows, const Rubric& rubric);

/// The same as a page with links to the reports, and with the mean of each column.
[[nodiscard]] std::string classHtml(const std::vector<ClassRow>& rows, const Rubric& rubric, Language language);

/// The work with the folder of its student: "ann/1.stl".
[[nodiscard]] std::string workOf(const ClassRow& row);

/// The trials of one student as a page, with links to the reports; beside their folders. `trend`: of those that could
/// be assessed; null: none.
[[nodiscard]] std::string studentHtml(const std::string& student, const std::vector<ClassRow>& rows,
                                      const Rubric& rubric, const TrialTrend* trend, Language language);

}  // namespace tactooth
