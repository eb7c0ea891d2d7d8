// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "assessment/agreement/bland_altman.h"
#include "assessment/agreement/failure_detection.h"
#include "assessment/agreement/intraclass.h"
#include "assessment/agreement/weighted_kappa.h"
#include "assessment/rubric/rubric.h"

namespace tactooth {

/// The level of a whole mark, 0..100: the one whose points (100, 85, 65) are nearest, the better one between two; a
/// mark below 65 fails, as a score of a criterion does.
[[nodiscard]] Level levelOfMark(double mark);

/// Levels of a mark: those of the enumeration Level, in its order.
inline constexpr std::size_t kMarkLevels = 4;

/// The mark of one work by the teachers and by the program, 0..100.
struct MarkPair {
    double teachers, program;
};

/// How far the marks of the program agree with those of the teachers.
struct MarkAgreement {
    std::size_t works = 0;
    std::optional<double> rms;                         ///< root mean square of the differences; nothing without a work
    std::optional<IntraclassCorrelation> icc;          ///< of two raters, the teachers and the program
    std::optional<BlandAltman> difference;             ///< program less teachers: a positive bias is a generous program
    ConfusionMatrix levels{kMarkLevels};               ///< rows: teachers; columns: program
    std::optional<Kappa> linearKappa, quadraticKappa;  ///< of these levels
    FailureDetection failures;                         ///< at the pass mark
    std::optional<double> areaUnderCurve;  ///< how well the program's mark separates what teachers pass and fail
};

/// `passMark`: 0..100; a mark below it fails.
[[nodiscard]] MarkAgreement markAgreement(std::span<const MarkPair> marks, double passMark);

}  // namespace tactooth
