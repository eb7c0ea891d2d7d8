// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/rubric/rubric.h"

#include <algorithm>
#include <cmath>

#include "assessment/messages.h"

namespace tactooth {
namespace {

constexpr double kLeastMark = 0.05;                       // rounds to 0.1
constexpr std::array kScores = {100.0, 85.0, 65.0, 0.0};  // at the ends of the ranges

/// The score of a value beyond the first end; `ends` rise.
double scoreBeyond(double value, const std::array<double, 4>& ends) {
    for (std::size_t i = 1; i < ends.size(); ++i) {
        if (value >= ends[i]) continue;
        const double share = (value - ends[i - 1]) / (ends[i] - ends[i - 1]);
        return kScores[i - 1] + share * (kScores[i] - kScores[i - 1]);
    }
    return 0;
}

Measured resultOf(const std::vector<MetricResult>& results, const PreparationMetric* metric) {
    const auto found = std::ranges::find(results, metric, &MetricResult::metric);
    TACTOOTH_ASSERT(found != results.end());
    return found->measured;
}

/// The best mark that a criterion allows.
double limitOf(const Rubric& rubric, const CriterionScore& each) {
    double limit = 100;
    if (!each.score) return limit;
    if (each.criterion->limitsMark) limit = *each.score;
    if (each.criterion->critical && *each.score == 0) limit = std::min(limit, rubric.criticalMark);
    return limit;
}

/// Lowers the mark by what limits it. Where nothing could be weighed, only a limit of 0 makes a mark: nothing was cut.
void applyLimits(const Rubric& rubric, Mark& mark) {
    const double before = mark.weighted.value_or(kLeastMark);
    for (const CriterionScore& each : mark.criteria) {
        const double limit = limitOf(rubric, each);
        if (limit >= before) continue;
        mark.limitedBy.push_back(each.criterion);
        mark.value = std::min(mark.value.value_or(0), limit);
    }
}

}  // namespace

const MessageText& levelText(Level level) {
    static constexpr std::array kTexts = {&msg::kLevelIdeal, &msg::kLevelAcceptable, &msg::kLevelCorrect,
                                          &msg::kLevelFail};
    return *kTexts[static_cast<std::size_t>(level)];
}

bool LevelRanges::areNested(const std::array<Range, 4>& ranges) {
    if (!(ranges[0].low <= ranges[0].high)) return false;
    const auto isOrdered = [&](const auto& end) {
        int equal = 0, wider = 0;
        for (std::size_t i = 1; i < ranges.size(); ++i) {
            equal += end(ranges[i]) == end(ranges[i - 1]) ? 1 : 0;
            wider += end(ranges[i]) > end(ranges[i - 1]) ? 1 : 0;
        }
        return equal == 3 || wider == 3;
    };
    return isOrdered([](const Range& range) { return range.high; }) &&
           isOrdered([](const Range& range) { return -range.low; });
}

double LevelRanges::scoreOf(double value) const {
    std::array<double, 4> ends{};
    if (hasUpperLimit() && value > ranges_[0].high) {
        std::ranges::transform(ranges_, ends.begin(), [](const Range& range) { return range.high; });
        return scoreBeyond(value, ends);
    }
    if (hasLowerLimit() && value < ranges_[0].low) {
        std::ranges::transform(ranges_, ends.begin(), [](const Range& range) { return -range.low; });
        return scoreBeyond(-value, ends);
    }
    return kScores[0];
}

Level LevelRanges::levelOf(double value) const {
    for (std::size_t i = 0; i < 3; ++i) {
        const bool low = !hasLowerLimit() || value >= ranges_[i].low;
        const bool high = !hasUpperLimit() || value <= ranges_[i].high;
        if (low && high) return static_cast<Level>(i);
    }
    return Level::Fail;
}

Mark markOf(const Rubric& rubric, const std::vector<MetricResult>& results) {
    Mark mark;
    double all = 0, judged = 0, sum = 0;
    for (const Criterion& criterion : rubric.criteria) {
        CriterionScore each{&criterion, resultOf(results, criterion.metric), {}, {}};
        all += criterion.weight;
        if (each.measured.value) {
            each.score = criterion.levels.scoreOf(*each.measured.value);
            each.level = criterion.levels.levelOf(*each.measured.value);
            judged += criterion.weight;
            sum += criterion.weight * *each.score;
        }
        mark.criteria.push_back(std::move(each));
    }
    if (judged > 0) {
        for (CriterionScore& each : mark.criteria) {
            if (each.score) each.lost = each.criterion->weight / judged * (100 - *each.score);
        }
        mark.judgedShare = judged / all;
        mark.weighted = sum / judged;
        mark.value = mark.weighted;
    }
    applyLimits(rubric, mark);
    if (!mark.value) return mark;
    mark.value = std::round(10 * *mark.value) / 10;
    mark.passes = *mark.value >= rubric.passMark;
    return mark;
}

}  // namespace tactooth
