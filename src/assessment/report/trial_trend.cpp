// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/report/trial_trend.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "assessment/agreement/median.h"
#include "assessment/report/messages.h"
#include "geometry/util/assert.h"

namespace tactooth {
namespace {

/// How many marks on each side lie outside the interval of the median: the most for which a fair coin, thrown `count`
/// times, shows at most so many heads with a probability of 2.5 %. Nothing if even none is too likely.
std::optional<std::size_t> outsideOfInterval(std::size_t count) {
    double share = std::pow(0.5, static_cast<double>(count)), sum = 0;  // of no head
    std::optional<std::size_t> outside;
    for (std::size_t heads = 0; heads <= count; ++heads) {
        sum += share;
        if (sum > (1 - kConfidence) / 2) break;
        outside = heads;
        share *= static_cast<double>(count - heads) / static_cast<double>(heads + 1);
    }
    return outside;
}

std::string inTenths(double mark) { return fmt::format("{:.1f}", mark); }

}  // namespace

RecentMarks recentMarks(std::span<const double> marks) {
    TACTOOTH_ASSERT(!marks.empty());
    const std::size_t count = std::min(marks.size(), kRecentTrials);
    std::vector<double> sorted(marks.end() - static_cast<std::ptrdiff_t>(count), marks.end());
    std::ranges::sort(sorted);
    RecentMarks recent{count, *medianOf(sorted), sorted.front(), sorted.back(), {}};
    if (const auto outside = outsideOfInterval(count))
        recent.interval = Interval{sorted[*outside], sorted[count - 1 - *outside]};
    return recent;
}

RecentMarks recentMarks(const TrialTrend& trend) {
    std::vector<double> marks;
    for (const TrialTrend::Trial& each : trend.trials) marks.push_back(each.mark);
    return recentMarks(marks);
}

std::vector<std::string> trendTexts(const TrialTrend& trend, Language language) {
    const RecentMarks recent = recentMarks(trend);
    std::vector<std::string> texts;
    if (recent.interval) {
        texts.push_back(Message(msg::kTrendInterval, recent.trials, inTenths(recent.median),
                                inTenths(recent.interval->low), inTenths(recent.interval->high))
                            .in(language));
    } else {
        texts.push_back(Message(msg::kTrendRange, recent.trials, inTenths(recent.median), inTenths(recent.low),
                                inTenths(recent.high))
                            .in(language));
    }
    return texts;
}

}  // namespace tactooth
