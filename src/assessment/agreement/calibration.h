// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/agreement/mark_agreement.h"
#include "assessment/agreement/rubric_fit.h"
#include "assessment/agreement/teacher_marks.h"
#include "geometry/util/expected.h"

namespace tactooth {

/// Fewer works or students say too little, and nothing about the next class.
inline constexpr std::size_t kLeastWorks = 10;
inline constexpr std::size_t kLeastStudents = 5;

/// A student's work as the program measures it.
struct MeasuredWork {
    std::string id, student;
    std::vector<MetricResult> results;  ///< of measureAll
};

/// The marks of one work.
struct CalibratedWork {
    std::string id, student;
    double teachers;                ///< mean of the teachers who marked it
    std::size_t teacherCount;       ///< 1 or more
    double start;                   ///< by the start rubric
    std::optional<double> fitted;   ///< by the fitted rubric
    std::optional<double> heldOut;  ///< by a rubric that was fitted without this student
};

/// A rubric that is fitted to the marks of a school's teachers, and how far the program agrees with them.
struct Calibration {
    RubricFit fit;                      ///< to all works
    std::vector<CalibratedWork> works;  ///< in the order of their ids
    std::size_t students = 0;
    std::size_t folds = 0;        ///< of the cross-validation: students, or groups of them, that were left out in turn
    std::size_t notMarked = 0;    ///< works without a mark of a teacher; left out
    std::size_t notMeasured = 0;  ///< works to which the start rubric gives no mark; left out

    TeacherAgreement teachers;  ///< among each other, on the same works
    MarkAgreement start;        ///< of the start rubric with the mean of the teachers
    MarkAgreement fitted;       ///< of the fitted rubric on the works that it was fitted to: too favourable
    MarkAgreement heldOut;      ///< the one to report: of the marks in `CalibratedWork::heldOut`

    /// Whether the fit comes closer to the teachers than the start rubric, for students whom it has not seen.
    [[nodiscard]] bool helps() const { return heldOut.rms && start.rms && *heldOut.rms < *start.rms; }
};

/// Fits `start` (fitRubric) to the mean marks of the teachers. Cross-validated by student, for works of one student are
/// alike: each student is left out once, or each of ten groups of more students.
///
/// Ids are unique, and so are the marks of a teacher for a work; the student is that of the work. The order of works
/// and marks changes nothing, and the same input gives the same bits. Fails with one sentence if a mark names an
/// unknown work, or if fewer than kLeastWorks works of kLeastStudents students have both marks. `start` outlives the
/// result.
[[nodiscard]] Expected<Calibration> calibrate(const Rubric& start, std::span<const MeasuredWork> works,
                                              std::span<const TeacherMark> marks);

}  // namespace tactooth
