// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/agreement/interval.h"

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <vector>

#include "assessment/agreement/seeded_random.h"

namespace tactooth {
namespace {

constexpr double kUpperTail = 0.5 + kConfidence / 2;
constexpr int kDraws = 2000;  // so that the ends change by less than a hundredth with another seed
constexpr std::uint64_t kBootstrapSeed = 20261127;

// What cannot be computed is not finite, instead of an exception.
using QuietPolicy =
    boost::math::policies::policy<boost::math::policies::domain_error<boost::math::policies::ignore_error>,
                                  boost::math::policies::pole_error<boost::math::policies::ignore_error>,
                                  boost::math::policies::overflow_error<boost::math::policies::ignore_error>,
                                  boost::math::policies::underflow_error<boost::math::policies::ignore_error>,
                                  boost::math::policies::evaluation_error<boost::math::policies::ignore_error>>;

std::optional<double> finite(double value) { return std::isfinite(value) ? std::optional(value) : std::nullopt; }

}  // namespace

std::optional<double> studentQuantile(double freedom) {
    TACTOOTH_ASSERT(freedom > 0);
    return finite(quantile(boost::math::students_t_distribution<double, QuietPolicy>(freedom), kUpperTail));
}

std::optional<double> fQuantile(double numeratorFreedom, double denominatorFreedom) {
    TACTOOTH_ASSERT(numeratorFreedom > 0 && denominatorFreedom > 0);
    const boost::math::fisher_f_distribution<double, QuietPolicy> distribution(numeratorFreedom, denominatorFreedom);
    return finite(quantile(distribution, kUpperTail));
}

std::optional<Interval> bootstrapInterval(std::size_t works, const WorkStatistic& statistic) {
    if (works < 2) return std::nullopt;
    SeededRandom random(kBootstrapSeed);
    std::vector<std::size_t> chosen(works);
    std::vector<double> values;
    values.reserve(kDraws);
    for (int draw = 0; draw < kDraws; ++draw) {
        for (std::size_t& each : chosen) each = static_cast<std::size_t>(random.below(works));
        if (const std::optional<double> value = statistic(chosen)) values.push_back(*value);
    }
    if (2 * values.size() <= kDraws) return std::nullopt;
    std::ranges::sort(values);
    const auto tail = static_cast<std::size_t>((1 - kUpperTail) * static_cast<double>(values.size()));
    return Interval{values[tail], values[values.size() - 1 - tail]};
}

}  // namespace tactooth
