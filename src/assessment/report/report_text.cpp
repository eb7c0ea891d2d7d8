// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "assessment/preparation/place_name.h"
#include "assessment/report/assessment_report.h"
#include "assessment/report/table_text.h"
#include "geometry/util/assert.h"
#include "geometry/util/number_text.h"

namespace tactooth {
namespace {

std::string number(const std::optional<double>& value) { return value ? numberText(*value) : std::string(); }

std::string placeCells(const Measured& measured) {
    if (!measured.place) return ",,";
    const Vec3& at = *measured.place;
    return numberText(at.x()) + ',' + numberText(at.y()) + ',' + numberText(at.z());
}

std::string reasonOf(const Measured& measured) {
    return measured.reason != nullptr ? std::string(measured.reason->english) : std::string();
}

/// Rounded, so that no value is shown as -0.
double tidy(double value, int decimals) {
    const double scale = std::pow(10.0, decimals);
    return std::round(value * scale) / scale + 0.0;
}

/// "2026-11-27 16:21 UTC" for "2026-11-27T16:21:29Z"; another text stays as it is.
std::string dateText(const std::string& date) {
    constexpr std::size_t kDay = 10, kMinutes = 16, kWhole = 20;
    if (date.size() != kWhole || date[kDay] != 'T' || date.back() != 'Z') return date;
    return date.substr(0, kDay) + ' ' + date.substr(kDay + 1, kMinutes - kDay - 1) + " UTC";
}

}  // namespace

std::string placeText(const AssessmentReport& report, const Vec3& place) {
    return std::string(placeName(place, report.middle, DentalDirections(report.axis, report.mesialX)).english);
}

std::string momentText(double seconds) {
    const auto whole = static_cast<long>(std::max(0.0, seconds));
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

std::string placeAndMomentText(const AssessmentReport& report, const Measured& measured) {
    std::string text;
    if (measured.place) text = placeText(report, *measured.place);
    if (measured.moment) text += (text.empty() ? "" : ", ") + momentText(*measured.moment);
    return text;
}

std::vector<ReportFact> reportFacts(const AssessmentReport& report) {
    std::vector<ReportFact> facts = {{"Work", report.student}, {"Compared with", report.expert}};
    if (!report.name.empty()) facts.push_back({"Student", report.name});
    if (!report.date.empty()) facts.push_back({"Date", dateText(report.date)});
    if (!report.task.empty()) facts.push_back({"Task", report.task});
    facts.push_back({"Rubric", report.rubric->name});
    if (report.seconds) facts.push_back({"Length of the session", momentText(*report.seconds) + " min"});
    if (report.fit) {
        facts.push_back(
            {"Fit of the surface on the uncut tooth",
             fmt::format("{:.3f} mm RMS over {:.0f} % of it", report.fit->residual, 100 * report.fit->usedShare)});
    }
    return facts;
}

std::string weightedMeanText(const Mark& mark) {
    if (!mark.weighted) return "No criterion with a weight could be measured, so there is no mark.";
    std::string text = fmt::format("Weighted mean of the scores: {:.1f}", *mark.weighted);
    if (mark.judgedShare < 1) {
        text += fmt::format(" (of {:.0f} % of the weights; the rest could not be measured)", 100 * mark.judgedShare);
    }
    return text + ".";
}

std::string resultText(const AssessmentReport& report) {
    return fmt::format("{}, pass mark {:.0f}", report.mark.passes ? "passed" : "failed", report.rubric->passMark);
}

std::string coloursText(const AssessmentReport& report) {
    return fmt::format(
        "White: within {:g} mm of the ideal preparation, or not to be cut. Blue: still to be cut. Orange: "
        "cut too deep. The colours are full from {:g} mm on.",
        report.tolerance, kColourRange);
}

std::string markText(std::size_t number, const WorkStrip::Mark& mark) {
    return fmt::format("{}  {}  {}", number, momentText(mark.time), mark.text);
}

std::vector<std::string> notMeasuredTexts(const AssessmentReport& report) {
    std::vector<std::pair<const MessageText*, std::string>> reasons;
    for (const auto& [metric, measured] : report.metrics) {
        if (measured.value) continue;
        const auto known =
            std::ranges::find(reasons, measured.reason, &std::pair<const MessageText*, std::string>::first);
        if (known == reasons.end()) {
            reasons.emplace_back(measured.reason, metric->title);
        } else {
            known->second += fmt::format("; {}", metric->title);
        }
    }
    std::vector<std::string> texts;
    for (const auto& [reason, titles] : reasons) {
        texts.push_back(fmt::format("Not measurable, because {}: {}.", reason->english, titles));
    }
    return texts;
}

std::string footerText(const AssessmentReport& report) {
    return "Measures and limits support a teacher's judgement; they do not replace it. Made by " + report.program + ".";
}

std::string_view levelColour(Level level) {
    constexpr std::array<std::string_view, 4> kColours = {"#2f7d4f", "#7a9a2d", "#cf8a16", "#b23a24"};
    return kColours[static_cast<std::size_t>(level)];
}

std::string valueText(const PreparationMetric& metric, double value) {
    if (metric.form == ValueForm::Share) return fmt::format("{:.1f} %", tidy(100 * value, 1));
    if (metric.form == ValueForm::Count) return fmt::format("{:.0f}", tidy(value, 0));
    struct Unit {
        std::string_view unit, text;
        int decimals;
    };
    constexpr std::array kUnits = {Unit{"1", "", 2},           Unit{"mm", " mm", 2},   Unit{"mm^2", " mm²", 2},
                                   Unit{"mm^3", " mm³", 2},    Unit{"deg", "°", 1},    Unit{"s", " s", 1},
                                   Unit{"N", " N", 2},         Unit{"N*s", " N·s", 1}, Unit{"Hz", " Hz", 1},
                                   Unit{"mm^3/s", " mm³/s", 3}};
    const auto* const unit = std::ranges::find(kUnits, metric.unit, &Unit::unit);
    TACTOOTH_ASSERT(unit != kUnits.end());
    return fmt::format("{:.{}f}{}", tidy(value, unit->decimals), unit->decimals, unit->text);
}

std::string reportCsv(const AssessmentReport& report) {
    std::string text = "kind,id,value,unit,score,weight,x,y,z,moment,note\n";
    text += "mark,mark," + number(report.mark.value) + ",,,,,,,," + (report.mark.passes ? "passed" : "failed") + '\n';
    for (const CriterionScore& each : report.mark.criteria) {
        const Criterion& criterion = *each.criterion;
        text += "criterion," + std::string(criterion.metric->id) + ',' + number(each.measured.value) + ',' +
                std::string(criterion.metric->unit) + ',' + number(each.score) + ',' + numberText(criterion.weight) +
                ',' + placeCells(each.measured) + ',' + number(each.measured.moment) + ',' +
                csvCell(each.score ? criterion.title : criterion.title + ": " + reasonOf(each.measured)) + '\n';
    }
    for (const auto& [metric, measured] : report.metrics) {
        text += "metric," + std::string(metric->id) + ',' + number(measured.value) + ',' + std::string(metric->unit) +
                ",,," + placeCells(measured) + ',' + number(measured.moment) + ',' + csvCell(reasonOf(measured)) + '\n';
    }
    return text;
}

}  // namespace tactooth
