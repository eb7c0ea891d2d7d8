// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "assessment/agreement/interval.h"

namespace tactooth {

/// A share of some works, with its interval by E. B. Wilson ("Probable inference, the law of succession, and
/// statistical inference", Journal of the American Statistical Association 22, 1927).
struct Share {
    std::size_t part, all;
    double value;  ///< 0..1
    Interval interval;
};
/// Nothing where `all` is 0.
[[nodiscard]] std::optional<Share> shareOf(std::size_t part, std::size_t all);

/// Whether a work failed, by the teachers and by the program.
struct Outcome {
    bool teachersFail, programFails;
};

/// How well the program finds the works that the teachers fail. A failing work is the positive outcome: a low
/// sensitivity passes bad work, a low specificity fails good work.
struct FailureDetection {
    std::size_t caught = 0;         ///< both fail it
    std::size_t missed = 0;         ///< the teachers alone fail it
    std::size_t wronglyFailed = 0;  ///< the program alone fails it
    std::size_t bothPass = 0;

    std::optional<Share> sensitivity;  ///< caught, of the works that the teachers fail; nothing if they fail none
    std::optional<Share> specificity;  ///< passed by both, of those that the teachers pass; nothing if they pass none
};
[[nodiscard]] FailureDetection failureDetection(std::span<const Outcome> outcomes);

/// How well a number separates two groups: the share of the pairs, one of each group, in which that of the upper group
/// is greater; ties count half. It is the area under the ROC curve (J. A. Hanley, B. J. McNeil, Radiology 143, 1982): 1
/// separates fully, 0.5 not at all. Nothing if a group is empty.
[[nodiscard]] std::optional<double> areaUnderCurve(std::span<const double> upper, std::span<const double> lower);

}  // namespace tactooth
