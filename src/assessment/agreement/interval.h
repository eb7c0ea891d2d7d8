// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>

namespace tactooth {

/// A 95 % confidence interval.
struct Interval {
    double low, high;
    bool operator==(const Interval&) const = default;
};

/// The share of the cases in which an interval holds the true value.
inline constexpr double kConfidence = 0.95;

/// Quantile of the standard normal distribution at 97.5 %.
inline constexpr double kNormalQuantile = 1.959963984540054;

/// Quantile of Student's t distribution at 97.5 %. `freedom` is more than 0. Nothing where it is too large for a
/// double.
[[nodiscard]] std::optional<double> studentQuantile(double freedom);

/// Quantile of the F distribution at 97.5 %, for any degrees of freedom over 0. Nothing where it is too large for a
/// double.
[[nodiscard]] std::optional<double> fQuantile(double numeratorFreedom, double denominatorFreedom);

/// A statistic of some of the works: `chosen` has their indices, some of them several times. Nothing where it is not
/// defined for them.
using WorkStatistic = std::function<std::optional<double>(std::span<const std::size_t> chosen)>;

/// Interval by the percentile bootstrap: 2,000 times as many works are drawn, with replacement, as there are (B. Efron,
/// R. J. Tibshirani, "An Introduction to the Bootstrap", 1993, chapter 13). The same input gives the same bits. Draws
/// for which the statistic is not defined are left out; nothing if these are more than half, or for fewer than two
/// works.
[[nodiscard]] std::optional<Interval> bootstrapInterval(std::size_t works, const WorkStatistic& statistic);

}  // namespace tactooth
