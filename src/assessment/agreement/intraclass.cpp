// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/agreement/intraclass.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

// Of the sum of squares of all ratings: smaller sums of squares are rounding.
constexpr double kRounding = 1e-24;

double squared(double value) { return value * value; }

std::optional<double> ratio(double above, double below) {
    return below > 0 ? std::optional(above / below) : std::nullopt;
}

/// Means of a table of ratings, and the sums of squares about them.
class RatingTable {
public:
    RatingTable(std::span<const double> ratings, std::size_t raters)
        : ratings_(ratings), raters_(raters), works_(ratings.size() / raters), rows_(works_), columns_(raters) {
        double size = 0;
        for (std::size_t i = 0; i < ratings.size(); ++i) {
            rows_[i / raters] += ratings[i] / static_cast<double>(raters);
            columns_[i % raters] += ratings[i] / static_cast<double>(works_);
            mean_ += ratings[i] / static_cast<double>(ratings.size());
            size += squared(ratings[i]);
        }
        least_ = kRounding * size;
    }

    [[nodiscard]] double ofWorks() const { return static_cast<double>(raters_) * about(rows_); }
    [[nodiscard]] double ofRaters() const { return static_cast<double>(works_) * about(columns_); }
    [[nodiscard]] double withinWorks() const {
        return sum([&](std::size_t i) { return ratings_[i] - rows_[i / raters_]; });
    }
    [[nodiscard]] double residual() const {
        return sum([&](std::size_t i) { return ratings_[i] - rows_[i / raters_] - columns_[i % raters_] + mean_; });
    }

private:
    template <class Deviation>
    double sum(const Deviation& deviation) const {
        double result = 0;
        for (std::size_t i = 0; i < ratings_.size(); ++i) result += squared(deviation(i));
        return result > least_ ? result : 0;
    }
    double about(const std::vector<double>& means) const {
        double result = 0;
        for (const double each : means) result += squared(each - mean_);
        return result > least_ ? result : 0;
    }

    std::span<const double> ratings_;
    std::size_t raters_, works_;
    std::vector<double> rows_, columns_;
    double mean_ = 0;
    double least_ = 0;
};

/// McGraw and Wong, table 7, case A,1. `n` works, `k` raters.
std::optional<Interval> intervalOf(const IntraclassCorrelation& icc, double n, double k) {
    if (!icc.agreement || *icc.agreement >= 1) return std::nullopt;
    const double r = *icc.agreement, works = icc.betweenWorks, raters = icc.betweenRaters, rest = icc.residual;
    const double a = k * r / (n * (1 - r)), b = 1 + a * (n - 1);
    const double spread = squared(a * raters) / (k - 1) + squared(b * rest) / ((n - 1) * (k - 1));
    const double freedom = squared(a * raters + b * rest) / spread;
    if (!(freedom > 0) || !std::isfinite(freedom)) return std::nullopt;
    const std::optional<double> below = fQuantile(n - 1, freedom), above = fQuantile(freedom, n - 1);
    if (!below || !above) return std::nullopt;
    const double errors = k * raters + (k * n - k - n) * rest;
    const auto low = ratio(n * (works - *below * rest), *below * errors + n * works);
    const auto high = ratio(n * (*above * works - rest), errors + n * *above * works);
    if (!low || !high) return std::nullopt;
    return Interval{*low, *high};
}

}  // namespace

std::optional<IntraclassCorrelation> intraclassCorrelation(std::span<const double> ratings, std::size_t raters) {
    if (raters < 2 || ratings.size() < 2 * raters) return std::nullopt;
    TACTOOTH_ASSERT(ratings.size() % raters == 0);
    TACTOOTH_ASSERT(std::ranges::all_of(ratings, [](double each) { return std::isfinite(each); }));
    const RatingTable table(ratings, raters);
    const std::size_t works = ratings.size() / raters;
    const auto n = static_cast<double>(works), k = static_cast<double>(raters);
    const double between = table.ofWorks() / (n - 1), judges = table.ofRaters() / (k - 1);
    const double within = table.withinWorks() / (n * (k - 1)), rest = table.residual() / ((n - 1) * (k - 1));
    IntraclassCorrelation icc{works, raters, between, judges, within, rest, {}, {}, {}, {}, {}, {}};
    icc.oneWay = ratio(between - within, between + (k - 1) * within);
    icc.agreement = ratio(between - rest, between + (k - 1) * rest + k * (judges - rest) / n);
    icc.consistency = ratio(between - rest, between + (k - 1) * rest);
    icc.meanAgreement = ratio(between - rest, between + (judges - rest) / n);
    icc.meanConsistency = ratio(between - rest, between);
    icc.agreementInterval = intervalOf(icc, n, k);
    return icc;
}

}  // namespace tactooth
