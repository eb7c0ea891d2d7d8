// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/agreement/weighted_kappa.h"

#include <numeric>

namespace tactooth {
namespace {

/// Squared or plain distance of two levels. The divisor (levels - 1) of the literature cancels out.
double weightOf(std::size_t first, std::size_t second, KappaWeights weights) {
    const double distance = first > second ? static_cast<double>(first - second) : static_cast<double>(second - first);
    return weights == KappaWeights::Quadratic ? distance * distance : distance;
}

}  // namespace

std::size_t ConfusionMatrix::total() const { return std::accumulate(counts_.begin(), counts_.end(), std::size_t{0}); }

std::optional<double> weightedKappa(const ConfusionMatrix& matrix, KappaWeights weights) {
    const std::size_t levels = matrix.levels();
    std::vector<double> rows(levels), columns(levels);
    double all = 0, seen = 0, guessed = 0;
    for (std::size_t i = 0; i < levels; ++i) {
        for (std::size_t j = 0; j < levels; ++j) {
            const auto count = static_cast<double>(matrix.at(i, j));
            rows[i] += count;
            columns[j] += count;
            all += count;
            seen += weightOf(i, j, weights) * count;
        }
    }
    for (std::size_t i = 0; i < levels; ++i) {
        for (std::size_t j = 0; j < levels; ++j) guessed += weightOf(i, j, weights) * rows[i] * columns[j];
    }
    if (guessed == 0) return std::nullopt;
    return 1 - all * seen / guessed;
}

std::optional<Kappa> kappaOf(std::span<const LevelPair> pairs, std::size_t levels, KappaWeights weights) {
    ConfusionMatrix matrix(levels);
    for (const LevelPair& pair : pairs) matrix.add(pair);
    const std::optional<double> value = weightedKappa(matrix, weights);
    if (!value) return std::nullopt;
    return Kappa{*value, bootstrapInterval(pairs.size(), [&](std::span<const std::size_t> chosen) {
                     ConfusionMatrix drawn(levels);
                     for (const std::size_t i : chosen) drawn.add(pairs[i]);
                     return weightedKappa(drawn, weights);
                 })};
}

}  // namespace tactooth
