// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/agreement/bland_altman.h"

#include <cmath>

namespace tactooth {
namespace {

constexpr double kLimit = 1.96;  // standard deviations, as published

Interval around(double middle, double half) { return {middle - half, middle + half}; }

}  // namespace

std::optional<BlandAltman> blandAltman(std::span<const double> differences) {
    if (differences.size() < 2) return std::nullopt;
    const auto n = static_cast<double>(differences.size());
    double sum = 0, squares = 0;
    for (const double each : differences) sum += each;
    const double bias = sum / n;
    for (const double each : differences) squares += (each - bias) * (each - bias);
    const double deviation = std::sqrt(squares / (n - 1));
    const std::optional<double> student = studentQuantile(n - 1);
    if (!student || !std::isfinite(deviation)) return std::nullopt;
    const double low = bias - kLimit * deviation, high = bias + kLimit * deviation;
    const double biasError = deviation / std::sqrt(n), limitError = deviation * std::sqrt(3 / n);
    return BlandAltman{differences.size(),
                       bias,
                       deviation,
                       low,
                       high,
                       biasError,
                       limitError,
                       around(bias, *student * biasError),
                       around(low, *student * limitError),
                       around(high, *student * limitError)};
}

}  // namespace tactooth
