// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "assessment/agreement/interval.h"

namespace tactooth {

/// How far two ways to mark the same works lie apart (J. M. Bland, D. G. Altman, "Statistical methods for assessing
/// agreement between two methods of clinical measurement", Lancet 327, 1986). All in the unit of the marks.
struct BlandAltman {
    std::size_t works;
    double bias;        ///< mean of the differences
    double deviation;   ///< their standard deviation (n - 1)
    double low, high;   ///< limits of agreement: bias -+ 1.96 deviations; 95 % of the differences lie between them
    double biasError;   ///< standard error of the bias
    double limitError;  ///< standard error of each limit, deviation * sqrt(3 / n)
    Interval biasInterval, lowInterval, highInterval;  ///< by Student's t with n - 1 degrees of freedom
};

/// `differences`: one way less the other, finite. Nothing for fewer than two.
[[nodiscard]] std::optional<BlandAltman> blandAltman(std::span<const double> differences);

}  // namespace tactooth
