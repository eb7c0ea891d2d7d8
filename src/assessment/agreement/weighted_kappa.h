// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "assessment/agreement/interval.h"
#include "geometry/util/assert.h"

namespace tactooth {

/// The levels that two raters gave the same work, from 0 on in their order.
struct LevelPair {
    std::size_t first, second;
};

/// How often one rater's level met another's: a row for each level of the first rater, a column for each of the second.
class ConfusionMatrix {
public:
    /// One level or more.
    explicit ConfusionMatrix(std::size_t levels) : levels_(levels), counts_(levels * levels) {}

    void add(const LevelPair& pair) {
        TACTOOTH_ASSERT(pair.first < levels_ && pair.second < levels_);
        ++counts_[pair.first * levels_ + pair.second];
    }
    [[nodiscard]] std::size_t levels() const { return levels_; }
    [[nodiscard]] std::size_t at(std::size_t first, std::size_t second) const {
        return counts_[first * levels_ + second];
    }
    [[nodiscard]] std::size_t total() const;

private:
    std::size_t levels_;
    std::vector<std::size_t> counts_;
};

/// What a disagreement counts: its number of levels, or that squared.
enum class KappaWeights { Linear, Quadratic };

/// Weighted kappa (J. Cohen, "Weighted kappa", Psychological Bulletin 70, 1968): 1 less the disagreement that was seen
/// over that of raters who guess with the same frequencies. 1: they agree in all; 0: not more than by chance. Nothing
/// without a pair, or where both raters gave one and the same level to all works.
[[nodiscard]] std::optional<double> weightedKappa(const ConfusionMatrix& matrix, KappaWeights weights);

/// Kappa with its interval by a bootstrap over works; each pair is one work.
struct Kappa {
    double value;
    std::optional<Interval> interval;
};
[[nodiscard]] std::optional<Kappa> kappaOf(std::span<const LevelPair> pairs, std::size_t levels, KappaWeights weights);

}  // namespace tactooth
