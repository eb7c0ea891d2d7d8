// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "assessment/report/assessment_report.h"
#include "assessment/report/messages.h"
#include "geometry/util/display_text.h"

namespace tactooth {
namespace {

const PreparationMetric& depthMetric() { return *findPreparationMetric("over_max"); }

/// Shows the tooth in the next full second after the error was made. A name that a shell would change has no command.
std::string commandFor(const AssessmentReport& report, const std::optional<RemovalCause>& cause,
                       const std::optional<double>& moment) {
    const bool isPlain = report.student.find('\'') == std::string::npos;
    if (!report.student.ends_with(".ttsession") || !isPlain || (!cause && !moment)) return {};
    const double last = cause ? cause->to : *moment;
    return fmt::format("tactooth replay '{}' --until {:.0f} --out moment", report.student, std::ceil(last));
}

/// Whether it has cost a point, or limits the mark.
bool hasCost(const AssessmentReport& report, const CriterionScore& each) {
    return each.lost > 0 || std::ranges::find(report.mark.limitedBy, each.criterion) != report.mark.limitedBy.end();
}

bool isListed(const AssessmentReport& report, const Vec3& place) {
    return std::ranges::any_of(report.errors, [&](const OverPreparation& each) { return each.place == place; });
}

/// Whether the criterion measures over-preparation at a place of `report.errors`.
bool isOverPreparation(const AssessmentReport& report, const CriterionScore& each) {
    if (!each.measured.place) return false;
    return each.criterion->metric == &depthMetric() || isListed(report, *each.measured.place);
}

}  // namespace

std::string causeText(const AssessmentReport& report, const CriterionScore& error, Language language) {
    const Measured& measured = error.measured;
    if (!measured.cause || !measured.place) return {};
    const RemovalCause& cause = *measured.cause;
    const std::string title = displayText(error.criterion->titleIn(language));
    const std::string value = valueText(*error.criterion->metric, *measured.value, language);
    const std::string place = placeText(report, *measured.place, language);
    const std::string from = momentText(cause.from), to = momentText(std::ceil(cause.to));
    const std::string force = fmt::format("{:.1f}", cause.force);
    if (!cause.tilt) return Message(msg::kCause, title, value, place, from, to, force).in(language);
    return Message(msg::kCauseTilted, title, value, place, from, to, force, fmt::format("{:.0f}", *cause.tilt))
        .in(language);
}

std::string overPreparationText(const AssessmentReport& report, const OverPreparation& error, Language language) {
    const std::string depth = valueText(depthMetric(), error.depth, language);
    const std::string place = placeText(report, error.place, language);
    if (!error.cause) return Message(msg::kOverPrepared, *error.wall, depth, place).in(language);
    const RemovalCause& cause = *error.cause;
    const std::string from = momentText(cause.from), to = momentText(std::ceil(cause.to));
    const std::string force = fmt::format("{:.1f}", cause.force);
    if (!cause.tilt) return Message(msg::kOverPreparedBetween, *error.wall, depth, place, from, to, force).in(language);
    return Message(msg::kOverPreparedTilted, *error.wall, depth, place, from, to, force,
                   fmt::format("{:.0f}", *cause.tilt))
        .in(language);
}

std::vector<ErrorText> errorTexts(const AssessmentReport& report, Language language) {
    constexpr std::size_t kMost = 5;
    std::vector<ErrorText> texts;
    std::vector<const CriterionScore*> others;
    bool isOverCostly = false;
    for (const CriterionScore& each : report.mark.criteria) {
        if (!hasCost(report, each)) continue;
        if (isOverPreparation(report, each)) {
            isOverCostly = true;
        } else if (!causeText(report, each, language).empty()) {
            others.push_back(&each);
        }
    }
    if (isOverCostly) {
        for (const OverPreparation& each : report.errors)
            texts.push_back({overPreparationText(report, each, language), commandFor(report, each.cause, each.moment)});
    }
    std::ranges::stable_sort(others, std::ranges::greater(), &CriterionScore::lost);
    for (const CriterionScore* each : others) {
        if (texts.size() == kMost) break;
        const Measured& measured = each->measured;
        texts.push_back({causeText(report, *each, language), commandFor(report, measured.cause, measured.moment)});
    }
    return texts;
}

}  // namespace tactooth
