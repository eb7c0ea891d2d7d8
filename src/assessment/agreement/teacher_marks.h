// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/agreement/intraclass.h"
#include "assessment/agreement/weighted_kappa.h"

namespace tactooth {

/// The mark that a teacher gave to a student's work.
struct TeacherMark {
    std::string work, student, teacher;
    double mark;  ///< 0..100
};

/// The student of each work, by the work's name.
[[nodiscard]] std::map<std::string, std::string> studentsOf(std::span<const TeacherMark> marks);

/// How far the teachers agree among each other.
struct TeacherAgreement {
    std::size_t teachers = 0;
    std::size_t works = 0;        ///< that a teacher marked
    std::size_t commonWorks = 0;  ///< that every teacher marked

    /// Of the common works; nothing for fewer than two of them, or for one teacher.
    std::optional<IntraclassCorrelation> icc;
    /// The mean of the quadratic kappas of the levels of each two teachers, over the works that both marked (R. J.
    /// Light, "Measures of response agreement for qualitative data", Psychological Bulletin 76, 1971). Two teachers
    /// without a kappa do not count; nothing if there are no others.
    std::optional<Kappa> kappa;
};

/// No teacher marks a work twice. The order of the marks changes nothing.
[[nodiscard]] TeacherAgreement teacherAgreement(std::span<const TeacherMark> marks);

}  // namespace tactooth
