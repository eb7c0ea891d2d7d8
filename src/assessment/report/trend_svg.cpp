// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/report/trend_svg.h"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>

#include "assessment/report/messages.h"
#include "assessment/report/svg_text.h"
#include "assessment/report/table_text.h"
#include "geometry/util/display_text.h"

namespace tactooth {
namespace {

constexpr std::size_t kMostShown = 20;  // trials: the last ones
constexpr std::size_t kMostCriteria = 3;
constexpr double kLeft = 7, kTop = 5, kBottom = 5, kGap = 5;  // mm around a plot and between two
constexpr double kMarkShare = 0.43;                           // of the width, for the plot of the mark
constexpr std::string_view kGrid = "stroke=\"#e3e8ec\" stroke-width=\"0.2\"";
constexpr std::string_view kPass = "stroke=\"#55636f\" stroke-width=\"0.2\" stroke-dasharray=\"1 0.8\"";
constexpr std::string_view kPassed = "#2f7d4f", kFailed = "#b23a24", kLine = "#5d83a8";

/// A plot of values of 0 to 100 over trials.
struct Plot {
    double left, right, top, bottom;  // mm
    std::size_t trials;

    [[nodiscard]] double x(std::size_t trial) const {
        return left + (right - left) * (static_cast<double>(trial) + 0.5) / static_cast<double>(trials);
    }
    [[nodiscard]] double y(double value) const { return bottom - (bottom - top) * std::clamp(value, 0.0, 100.0) / 100; }

    /// `first`: the number of the first trial, from 1.
    [[nodiscard]] std::string frame(const std::string& title, std::size_t first) const {
        std::string svg = svgText(left, top - 1.6, "start", htmlText(title));
        for (const int tick : {0, 50, 100}) {
            svg += svgLine(left, y(tick), right, y(tick), kGrid);
            svg += svgText(left - 1, y(tick) + 0.8, "end", fmt::format("{}", tick));
        }
        const std::size_t step = (trials - 1) / 10 + 1;
        for (std::size_t i = 0; i < trials; i += step)
            svg += svgText(x(i), bottom + 3.4, "middle", fmt::format("{}", first + i));
        return svg;
    }
    [[nodiscard]] std::string line(const std::vector<std::optional<double>>& values) const {
        std::string path;
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (values[i]) path += fmt::format("{}{:.2f} {:.2f}", path.empty() ? "M" : "L", x(i), y(*values[i]));
        }
        return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"0.3\"/>\n", path, kLine);
    }
    [[nodiscard]] std::string point(std::size_t trial, double value, std::string_view colour) const {
        const double radius = trial + 1 == trials ? 1.1 : 0.75;  // the present trial stands out
        return fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{}\" fill=\"{}\"/>\n", x(trial), y(value), radius,
                           colour);
    }
};

/// The median of the last trials, with its interval as a band.
std::string recentBand(const Plot& plot, const RecentMarks& recent) {
    const std::size_t shown = std::min(recent.trials, plot.trials);
    const double half = (plot.right - plot.left) / static_cast<double>(plot.trials) / 2;
    const double from = plot.x(plot.trials - shown) - half, to = plot.x(plot.trials - 1) + half;
    std::string svg;
    if (recent.interval) {
        const double top = plot.y(recent.interval->high), bottom = plot.y(recent.interval->low);
        svg += fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"#dbe6f1\"/>\n",
                           from, top, to - from, std::max(0.1, bottom - top));
    }
    return svg +
           svgLine(from, plot.y(recent.median), to, plot.y(recent.median), "stroke=\"#1c66b8\" stroke-width=\"0.4\"");
}

/// The criteria that cost most in the last trials, by their numbers in the rubric.
std::vector<std::size_t> costliest(const TrialTrend& trend, std::size_t criteria) {
    std::vector<double> costs(criteria);
    const std::size_t recent = std::min(trend.trials.size(), kRecentTrials);
    for (std::size_t trial = trend.trials.size() - recent; trial < trend.trials.size(); ++trial) {
        for (std::size_t i = 0; i < criteria; ++i) costs[i] += trend.trials[trial].scores[i].cost;
    }
    std::vector<std::size_t> numbers(criteria);
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    std::erase_if(numbers, [&](std::size_t i) { return costs[i] <= 0; });
    std::ranges::stable_sort(numbers, [&](std::size_t a, std::size_t b) { return costs[a] > costs[b]; });
    if (numbers.size() > kMostCriteria) numbers.resize(kMostCriteria);
    return numbers;
}

}  // namespace

std::string trendSvg(const TrialTrend& trend, const Rubric& rubric, double width, double height, Language language) {
    const std::size_t shown = std::min(trend.trials.size(), kMostShown), first = trend.trials.size() - shown;
    const std::span<const TrialTrend::Trial> trials = std::span(trend.trials).subspan(first);
    std::string svg = svgHead(width, height);
    const Plot marks{kLeft, kMarkShare * width, kTop, height - kBottom, shown};
    svg += recentBand(marks, recentMarks(trend)) + marks.frame(std::string(msg::kHeadMark.in(language)), first + 1);
    svg += svgLine(marks.left, marks.y(rubric.passMark), marks.right, marks.y(rubric.passMark), kPass);
    std::vector<std::optional<double>> values;
    for (const TrialTrend::Trial& each : trials) values.emplace_back(each.mark);
    svg += marks.line(values);
    for (std::size_t i = 0; i < shown; ++i) svg += marks.point(i, trials[i].mark, trials[i].passes ? kPassed : kFailed);
    const double each = (width - marks.right) / kMostCriteria;
    double left = marks.right;
    for (const std::size_t number : costliest(trend, rubric.criteria.size())) {
        const Plot plot{left + kGap + 3, left + each, kTop, height - kBottom, shown};
        const std::size_t letters = language == Language::Japanese ? 11 : 19;
        svg += plot.frame(displayShort(rubric.criteria[number].titleIn(language), letters), first + 1);
        for (std::size_t i = 0; i < shown; ++i) values[i] = trials[i].scores[number].value;
        svg += plot.line(values);
        for (std::size_t i = 0; i < shown; ++i) {
            if (values[i]) svg += plot.point(i, *values[i], kLine);
        }
        left += each;
    }
    return svg + "</svg>\n";
}

}  // namespace tactooth
