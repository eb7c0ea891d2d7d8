// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "assessment/preparation/place_name.h"
#include "assessment/report/assessment_report.h"
#include "assessment/report/messages.h"
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
std::string dateText(const std::string& date, Language language) {
    constexpr std::size_t kDay = 10, kWhole = 20;
    if (date.size() != kWhole || date[kDay] != 'T' || date.back() != 'Z') return date;
    return Message(msg::kReportDay, date.substr(0, 4), date.substr(5, 2), date.substr(8, 2), date.substr(kDay + 1, 5))
        .in(language);
}

std::string number(double value, int decimals) { return fmt::format("{:.{}f}", value, decimals); }

/// What stands before or after a value in a language: a unit.
struct Unit {
    std::string_view unit, english, japanese;
    int decimals;
};
constexpr std::array kUnits = {Unit{"1", "", "", 2},
                               Unit{"mm", " mm", " mm", 2},
                               Unit{"mm^2", " mm²", " mm²", 2},
                               Unit{"mm^3", " mm³", " mm³", 2},
                               Unit{"deg", "°", "°", 1},
                               Unit{"s", " s", " 秒", 1},
                               Unit{"N", " N", " N", 2},
                               Unit{"N*s", " N·s", " N·s", 1},
                               Unit{"Hz", " Hz", " Hz", 1},
                               Unit{"mm^3/s", " mm³/s", " mm³/s", 3}};

}  // namespace

std::string placeText(const AssessmentReport& report, const Vec3& place, Language language) {
    return std::string(placeName(place, report.middle, DentalDirections(report.axis, report.mesialX)).in(language));
}

std::string momentText(double seconds) {
    const auto whole = static_cast<long>(std::max(0.0, seconds));
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

std::string placeAndMomentText(const AssessmentReport& report, const Measured& measured, Language language) {
    const std::string place = measured.place ? placeText(report, *measured.place, language) : std::string();
    if (!measured.moment) return place;
    if (place.empty()) return momentText(*measured.moment);
    return Message(msg::kPlaceAndMoment, place, momentText(*measured.moment)).in(language);
}

std::vector<ReportFact> reportFacts(const AssessmentReport& report) {
    const Language language = report.language;
    const bool isJapanese = language == Language::Japanese;
    std::vector<ReportFact> facts;
    const auto add = [&](const MessageText& title, std::string value) {
        if (!value.empty()) facts.push_back({title.in(language), std::move(value)});
    };
    add(msg::kFactWork, report.student);
    add(msg::kFactComparedWith, isJapanese && !report.japaneseExpert.empty() ? report.japaneseExpert : report.expert);
    add(msg::kFactStudent, report.name);
    add(msg::kFactDate, dateText(report.date, language));
    add(msg::kFactTask, isJapanese && !report.japaneseTask.empty() ? report.japaneseTask : report.task);
    add(msg::kFactRubric, report.rubric->nameIn(language));
    if (report.seconds) add(msg::kFactLength, Message(msg::kFactMinutes, momentText(*report.seconds)).in(language));
    if (report.fit) {
        add(msg::kFactFit,
            Message(msg::kFactFitValue, number(report.fit->residual, 3), number(100 * report.fit->usedShare, 0))
                .in(language));
    }
    return facts;
}

std::string weightedMeanText(const Mark& mark, Language language) {
    if (!mark.weighted) return std::string(msg::kNoMark.in(language));
    const std::string mean = number(*mark.weighted, 1);
    if (mark.judgedShare == 1) return Message(msg::kWeightedMean, mean).in(language);
    return Message(msg::kWeightedMeanOfPart, mean, number(100 * mark.judgedShare, 0)).in(language);
}

std::string limitedByText(const AssessmentReport& report, const Criterion& criterion) {
    return Message(msg::kMarkLimitedBy, criterion.titleIn(report.language)).in(report.language);
}

std::string criterionText(const AssessmentReport& report, const Criterion& criterion) {
    const std::string& title = criterion.titleIn(report.language);
    return criterion.critical ? Message(msg::kCriticalCriterion, title).in(report.language) : title;
}

std::string resultText(const AssessmentReport& report) {
    return Message(msg::kResultOfPassMark, report.mark.passes ? msg::kPassed : msg::kFailed,
                   number(report.rubric->passMark, 0))
        .in(report.language);
}

std::string coloursText(const AssessmentReport& report) {
    return Message(msg::kPictureColours, fmt::format("{:g}", report.tolerance), fmt::format("{:g}", kColourRange))
        .in(report.language);
}

std::string markText(std::size_t number, const WorkStrip::Mark& mark) {
    return fmt::format("{}  {}  {}", number, momentText(mark.time), mark.text);
}

std::vector<std::string> notMeasuredTexts(const AssessmentReport& report) {
    const Language language = report.language;
    std::vector<std::pair<const MessageText*, std::string>> reasons;
    for (const auto& [metric, measured] : report.metrics) {
        if (measured.value) continue;
        const auto known =
            std::ranges::find(reasons, measured.reason, &std::pair<const MessageText*, std::string>::first);
        if (known == reasons.end()) {
            reasons.emplace_back(measured.reason, metric->titleIn(language));
        } else {
            known->second = Message(msg::kTwoOfList, known->second, metric->titleIn(language)).in(language);
        }
    }
    std::vector<std::string> texts;
    for (const auto& [reason, titles] : reasons) {
        texts.push_back(Message(msg::kNotMeasured, *reason, titles).in(language));
    }
    return texts;
}

std::string footerText(const AssessmentReport& report) {
    return Message(msg::kReportFooter, report.program).in(report.language);
}

std::string_view levelColour(Level level) {
    constexpr std::array<std::string_view, 4> kColours = {"#2f7d4f", "#7a9a2d", "#cf8a16", "#b23a24"};
    return kColours[static_cast<std::size_t>(level)];
}

std::string valueText(const PreparationMetric& metric, double value, Language language) {
    if (metric.form == ValueForm::Share) return fmt::format("{:.1f} %", tidy(100 * value, 1));
    if (metric.form == ValueForm::Count) return fmt::format("{:.0f}", tidy(value, 0));
    const auto* const unit = std::ranges::find(kUnits, metric.unit, &Unit::unit);
    TACTOOTH_ASSERT(unit != kUnits.end());
    return fmt::format("{:.{}f}{}", tidy(value, unit->decimals), unit->decimals,
                       language == Language::English ? unit->english : unit->japanese);
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
