// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/study/study_page.h"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "assessment/report/assessment_report.h"
#include "assessment/report/page_head.h"
#include "assessment/report/table_text.h"
#include "assessment/study/messages.h"
#include "geometry/util/display_text.h"
#include "geometry/util/number_text.h"

namespace tactooth {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kStyle = R"css(
@page { size: A4; margin: 14mm }
body { font-size: 10pt; line-height: 1.4; color: #1d2730; margin: 0 auto; max-width: 182mm; padding: 6mm }
h1 { font-size: 17pt; margin: 0 0 2mm } p { margin: 1mm 0 }
h2 { font-size: 11.5pt; margin: 6mm 0 1mm } .small { font-size: 8.5pt; color: #55636f }
.synthetic { border-left: 1mm solid #b4770b; padding-left: 3mm; margin: 3mm 0 }
.passed { color: #17603a; font-weight: 600 } .failed { color: #9c2b1a; font-weight: 600 }
table { border-collapse: collapse; width: 100% } tr { page-break-inside: avoid } thead { display: table-header-group }
th { text-align: left; vertical-align: bottom; font-weight: 600; font-size: 8.5pt; color: #55636f }
td, th { padding: 0.6mm 2mm 0.6mm 0; border-bottom: 0.2mm solid #e3e8ec }
td.n, th.n { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap }
)css";

std::string cell(std::string_view text, std::string_view attributes = "") {
    return fmt::format("<td{}{}>{}</td>", attributes.empty() ? "" : " ", attributes, htmlText(text));
}
std::string head(std::string_view text, bool isNumber) {
    return fmt::format("<th{}>{}</th>", isNumber ? " class=\"n\"" : "", htmlText(text));
}
constexpr std::string_view kNumber = "class=\"n\"";

std::string areaText(const LevelContrast& contrast) {
    if (!contrast.area) return "–";
    if (!contrast.interval) return fmt::format("{:.2f}", *contrast.area);
    return fmt::format("{:.2f} ({:.2f}–{:.2f})", *contrast.area, contrast.interval->low, contrast.interval->high);
}

std::string levelsTable(const StudyReport& report, Language language) {
    std::string text = "<table><thead><tr>" + head(msg::kStudyMetric.in(language), false);
    for (const HandLevel level : kHandLevels) text += head(titleOf(level).in(language), true);
    text += head(msg::kStudyApart.in(language), true) + "</tr></thead>\n";
    const auto row = [&](std::string_view title, const LevelContrast& contrast, const auto& textOf) {
        text += "<tr>" + cell(title);
        for (const auto& median : contrast.medians) text += cell(median ? textOf(*median) : "–", kNumber);
        text += cell(areaText(contrast), kNumber) + "</tr>\n";
    };
    row(msg::kStudyMark.in(language), contrastOf(report.trials, markValue),
        [](double mark) { return fmt::format("{:.1f}", mark); });
    const auto metrics = preparationMetrics();
    for (std::size_t i = 0; i < metrics.size(); ++i) {
        const LevelContrast contrast = contrastOf(report.trials, metricValue(i));
        if (!contrast.area) continue;  // this exercise has nothing to measure there
        row(metrics[i].titleIn(language), contrast,
            [&](double value) { return valueText(metrics[i], value, language); });
    }
    return text + "</table>\n";
}

std::string amountText(const HandHabit& habit, double amount) {
    if (habit.unit == "1") return fmt::format("{:.0f} %", 100 * amount);
    return fmt::format("{:.2f} {}", amount, habit.unit);
}

std::string habitsTable(const StudyReport& report, Language language) {
    std::string text = "<table><thead><tr>" + head(msg::kStudyHabit.in(language), false) +
                       head(msg::kStudyMetric.in(language), false) + "<th></th><th></th><th></th><th></th>" +
                       head(msg::kStudyShown.in(language), true) + "</tr></thead>\n";
    const HandHabit* last = nullptr;
    for (const ShownHabit& each : shownHabits(report.trials)) {
        if (each.habit != last) {
            text += "<tr>" + cell(each.habit->title->in(language)) + cell("");
            for (const StudyTrial& trial : report.trials) {
                if (trial.hand.varied != each.habit) continue;
                text += cell(amountText(*each.habit, trial.hand.habits.*each.habit->value), kNumber);
            }
            text += cell("") + "</tr>\n";
            last = each.habit;
        }
        const PreparationMetric& metric = preparationMetrics()[each.metric];
        text += "<tr>" + cell("") + cell(fmt::format("{} {}", metric.titleIn(language), each.rises ? "↑" : "↓"));
        for (const auto& value : each.values) text += cell(value ? valueText(metric, *value, language) : "–", kNumber);
        text += cell((each.isShown ? msg::kStudyYes : msg::kStudyNo).in(language),
                     each.isShown ? "class=\"n passed\"" : "class=\"n failed\"") +
                "</tr>\n";
    }
    return text + "</table>\n";
}

std::string paragraph(std::string_view text, std::string_view style) {
    return fmt::format("<p class=\"{}\">{}</p>\n", style, htmlText(text));
}
std::string heading(const MessageText& text, Language language) {
    return "<h2>" + htmlText(text.in(language)) + "</h2>\n";
}

std::string_view wordOf(HandLevel level) { return titleOf(level).in(Language::English); }
Json numberOrNull(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json contrastJson(const LevelContrast& contrast) {
    Json json;
    for (const HandLevel level : kHandLevels)
        json["median"][wordOf(level)] = numberOrNull(contrast.medians[static_cast<std::size_t>(level)]);
    json["expert_over_beginner"] = numberOrNull(contrast.area);
    if (contrast.interval) json["interval"] = {contrast.interval->low, contrast.interval->high};
    return json;
}

}  // namespace

std::string studyResultText(const StudyReport& report, Language language) {
    if (passesSelfTest(report.trials)) return std::string(msg::kStudyPassed.in(language));
    const std::vector<ShownHabit> shown = shownHabits(report.trials);
    const auto missing = std::ranges::count(shown, false, &ShownHabit::isShown);
    return Message(msg::kStudyFailed, static_cast<std::size_t>(missing), shown.size(),
                   areaText(contrastOf(report.trials, markValue)))
        .in(language);
}

std::string studyHtml(const StudyReport& report, Language language) {
    const std::string_view title = msg::kStudyTitle.in(language);
    const bool hasJapanese = language == Language::Japanese && !report.japaneseExercise.empty();
    const Message scene(msg::kStudyScene, displayText(hasJapanese ? report.japaneseExercise : report.exercise),
                        displayText(report.rubric->nameIn(language)), report.handsOfLevel, std::to_string(report.seed));
    std::string text = pageHead(title, kStyle, language) + "<h1>" + htmlText(title) + "</h1>\n";
    text += paragraph(msg::kStudyMeaning.in(language), "synthetic");
    text += paragraph(scene.in(language), "");
    text += paragraph(studyResultText(report, language), passesSelfTest(report.trials) ? "passed" : "failed");
    text += heading(msg::kStudyHabits, language) + paragraph(msg::kStudyHabitsNote.in(language), "small");
    text += habitsTable(report, language);
    text += heading(msg::kStudyLevels, language) + paragraph(msg::kStudyLevelsNote.in(language), "small");
    text += levelsTable(report, language);
    return text + paragraph(report.program, "small") + "</body></html>\n";
}

std::string studyCsv(const StudyReport& report) {
    std::string text = "synthetic_hand,level,varied,seed";
    for (const HandHabit& each : handHabits()) text += ",habit_" + std::string(each.id);
    text += ",mark,passes";
    for (const PreparationMetric& each : preparationMetrics()) text += ',' + std::string(each.id);
    text += '\n';
    for (const StudyTrial& each : report.trials) {
        const StudyHand& hand = each.hand;
        text += hand.name + ',' + std::string(wordOf(hand.level)) + ',' +
                std::string(hand.varied != nullptr ? hand.varied->id : "") + ',' + std::to_string(hand.seed);
        for (const HandHabit& habit : handHabits()) text += ',' + numberText(hand.habits.*habit.value);
        text += ',' + (each.mark.value ? numberText(*each.mark.value) : "") + (each.mark.passes ? ",1" : ",0");
        for (const auto& [metric, measured] : each.metrics)
            text += ',' + (measured.value ? numberText(*measured.value) : "");
        text += '\n';
    }
    return text;
}

std::string studyJson(const StudyReport& report) {
    Json json = {{"format", 1},
                 {"synthetic", true},
                 {"meaning", std::string(msg::kStudyMeaning.in(Language::English))},
                 {"exercise", report.exercise},
                 {"rubric", report.rubric->name},
                 {"hands_of_each_level", report.handsOfLevel},
                 {"seed", report.seed},
                 {"program", report.program},
                 {"passes", passesSelfTest(report.trials)},
                 {"mark", contrastJson(contrastOf(report.trials, markValue))},
                 {"metrics", Json::array()},
                 {"habits", Json::array()},
                 {"hands", Json::array()}};
    const auto metrics = preparationMetrics();
    for (std::size_t i = 0; i < metrics.size(); ++i) {
        Json one = {{"id", metrics[i].id}, {"unit", metrics[i].unit}};
        one.update(contrastJson(contrastOf(report.trials, metricValue(i))));
        json["metrics"].push_back(std::move(one));
    }
    for (const ShownHabit& each : shownHabits(report.trials)) {
        Json one = {{"habit", each.habit->id}, {"metric", metrics[each.metric].id}, {"rises", each.rises},
                    {"values", Json::array()}, {"tau", numberOrNull(each.tau)},     {"shown", each.isShown}};
        for (const auto& value : each.values) one["values"].push_back(numberOrNull(value));
        json["habits"].push_back(std::move(one));
    }
    for (const StudyTrial& each : report.trials) {
        Json one = {{"hand", each.hand.name},
                    {"level", wordOf(each.hand.level)},
                    {"varied", each.hand.varied != nullptr ? Json(each.hand.varied->id) : Json()},
                    {"mark", numberOrNull(each.mark.value)},
                    {"pass", each.mark.passes}};
        for (const HandHabit& habit : handHabits())
            one["habits"][std::string(habit.id)] = each.hand.habits.*habit.value;
        json["hands"].push_back(std::move(one));
    }
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace tactooth
