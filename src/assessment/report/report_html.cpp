// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <algorithm>

#include "assessment/report/assessment_report.h"
#include "assessment/report/messages.h"
#include "assessment/report/next_steps.h"
#include "assessment/report/page_head.h"
#include "assessment/report/strip_svg.h"
#include "assessment/report/table_text.h"
#include "assessment/report/trend_svg.h"

namespace tactooth {
namespace {

constexpr std::string_view kStyle = R"css(
@page { size: A4; margin: 14mm }
body { font-size: 10pt; line-height: 1.35; color: #1d2730; margin: 0 auto; max-width: 182mm; padding: 6mm }
h1 { font-size: 17pt; margin: 0 0 1mm }
h2 { font-size: 11.5pt; margin: 6mm 0 2mm; border-bottom: 0.3mm solid #c9d2d9; padding-bottom: 1mm }
p { margin: 1mm 0 }
table { border-collapse: collapse; width: 100% }
th { text-align: left; font-weight: 600; font-size: 8.5pt; color: #55636f; border-bottom: 0.3mm solid #8a97a1 }
td, th { padding: 1mm 2mm 1mm 0; vertical-align: top }
tbody td { border-bottom: 0.2mm solid #e3e8ec }
tr { page-break-inside: avoid }
td.n, th.n { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums }
.none { color: #6a7781 }
.head { display: flex; justify-content: space-between; gap: 8mm; align-items: flex-start }
.mark { border: 0.5mm solid; border-radius: 2mm; padding: 2mm 5mm; text-align: center; min-width: 30mm }
.mark b { display: block; font-size: 26pt; line-height: 1.1 }
.passed { color: #17603a } .failed { color: #9c2b1a }
.bar { background: #e3e8ec; height: 2.4mm; width: 22mm; margin-top: 1mm } .bar i { display: block; height: 100% }
.pictures { display: flex; flex-wrap: wrap; gap: 3mm } figure { margin: 0; width: 58mm; page-break-inside: avoid }
figure img { width: 100%; display: block } figcaption { font-size: 8.5pt; color: #55636f }
.sections { display: flex; gap: 6mm } ol { margin: 1mm 0; padding-left: 5mm } svg { max-width: 100%; height: auto }
.comment { border: 0.3mm solid #c9d2d9; min-height: 14mm; padding: 1mm 2mm; white-space: pre-wrap }
.small { font-size: 8.5pt; color: #55636f }
)css";

/// A heading.
std::string h2(const AssessmentReport& report, const MessageText& title) {
    return fmt::format("<h2>{}</h2>\n", htmlText(title.in(report.language)));
}

/// The head of a table; `isNumber`: its column is set to the right.
std::string th(const AssessmentReport& report, const MessageText& title, bool isNumber = false) {
    return fmt::format("<th{}>{}</th>", isNumber ? " class=\"n\"" : "", title.in(report.language));
}

std::string head(const AssessmentReport& report) {
    const Mark& mark = report.mark;
    std::string text =
        "<div class=\"head\"><div><h1>" + std::string(msg::kReportTitle.in(report.language)) + "</h1>\n<p>";
    const std::vector<ReportFact> facts = reportFacts(report);
    for (std::size_t i = 0; i < facts.size(); ++i) {
        const std::string value = i < 2 ? "<b>" + htmlText(facts[i].value) + "</b>" : htmlText(facts[i].value);
        text += (i > 0 ? "<br>" : "") + std::string(facts[i].title) + ": " + value;
    }
    text += "</p></div>\n";
    text += fmt::format("<div class=\"mark {}\"><b>{}</b>{}<br>{}</div></div>\n", mark.passes ? "passed" : "failed",
                        mark.value ? fmt::format("{:.1f}", *mark.value) : "–", msg::kOfHundred.in(report.language),
                        resultText(report));
    return text;
}

std::string scoreCell(const AssessmentReport& report, const CriterionScore& each) {
    if (!each.score) return "<td class=\"n none\">–</td><td></td>";
    return fmt::format(
        "<td class=\"n\">{:.0f}</td><td>{}<div class=\"bar\"><i style=\"width:{:.0f}%;background:{}\"></i></div></td>",
        *each.score, levelText(*each.level).in(report.language), std::max(2.0, *each.score), levelColour(*each.level));
}

std::string criterionRow(const AssessmentReport& report, const CriterionScore& each) {
    const Criterion& criterion = *each.criterion;
    std::string text = "<tr><td>" + htmlText(criterionText(report, criterion)) + "</td>";
    if (each.measured.value) {
        text += "<td class=\"n\">" + valueText(*criterion.metric, *each.measured.value, report.language) + "</td>";
    } else {
        text += fmt::format("<td class=\"n none\">{}</td>", msg::kNotMeasurable.in(report.language));
    }
    text += scoreCell(report, each);
    text += criterion.weight > 0 ? fmt::format("<td class=\"n\">{:g}</td>", criterion.weight)
                                 : fmt::format("<td class=\"n\">{}</td>", msg::kOnlyLimit.in(report.language));
    text += each.lost > 0 ? fmt::format("<td class=\"n\">−{:.1f}</td>", each.lost) : "<td></td>";
    return text + "<td>" + placeAndMomentText(report, each.measured) + "</td></tr>\n";
}

std::string madeOf(const AssessmentReport& report) {
    const Mark& mark = report.mark;
    std::string text = h2(report, msg::kReportMadeOf) + "<table><thead><tr>" + th(report, msg::kHeadCriterion);
    text += th(report, msg::kHeadMeasured, true) + th(report, msg::kHeadScore, true) + th(report, msg::kHeadLevel);
    text += th(report, msg::kHeadWeight, true) + th(report, msg::kHeadLost, true) + th(report, msg::kHeadWhere);
    text += "</tr></thead><tbody>\n";
    for (const CriterionScore& each : mark.criteria) text += criterionRow(report, each);
    text += "</tbody></table>\n";
    text += "<p>" + weightedMeanText(mark, report.language) + "</p>\n";
    for (const Criterion* each : mark.limitedBy) {
        text += "<p><b>" + htmlText(limitedByText(report, *each)) + "</b></p>\n";
    }
    for (const ErrorText& each : errorTexts(report)) {
        text += "<p>" + htmlText(each.text);
        const std::string command = "<code>" + htmlText(each.command) + "</code>";
        if (!each.command.empty()) text += "<br>" + Message(msg::kToSeeIt, command).in(report.language);
        text += "</p>\n";
    }
    return text;
}

std::string trend(const AssessmentReport& report) {
    if (!report.trend) return {};
    constexpr double kWidth = 182, kHeight = 36;  // mm
    std::string text = h2(report, msg::kReportTrend);
    text += trendSvg(*report.trend, *report.rubric, kWidth, kHeight, report.language);
    for (const std::string& each : trendTexts(*report.trend, report.language))
        text += "<p class=\"small\">" + htmlText(each) + "</p>\n";
    return text;
}

std::string pictures(const AssessmentReport& report) {
    std::string text = h2(report, msg::kReportDistance);
    if (report.pictures.empty()) return text + "<p class=\"none\">" + htmlText(report.noPictures) + "</p>\n";
    text += "<p class=\"small\">" + coloursText(report) + "</p>\n<div class=\"pictures\">\n";
    for (const ReportPicture& each : report.pictures) {
        text += "<figure><img alt=\"" + htmlText(each.title) + "\" src=\"data:image/png;base64," + each.pngBase64 +
                "\"><figcaption>" + htmlText(each.title) + "</figcaption></figure>\n";
    }
    return text + "</div>\n";
}

std::string advice(const AssessmentReport& report) {
    std::string text = h2(report, msg::kReportNext) + "<ul>";
    for (const std::string& step : nextSteps(report)) text += "<li>" + htmlText(step) + "</li>";
    text += "</ul>\n" + h2(report, msg::kReportComment) + "<div class=\"comment\">";
    std::string_view rest = report.comment;
    while (!rest.empty()) {  // lines stay lines
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        text += htmlText(rest.substr(0, end)) + "\n";
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return text + "</div>\n";
}

std::string sections(const AssessmentReport& report) {
    if (report.sections.empty()) return {};
    constexpr double kWidth = 86;  // mm
    std::string text = h2(report, msg::kReportSections) + "<div class=\"sections\">\n";
    for (const ReportSection& each : report.sections) {
        text += "<figure style=\"width:86mm\">" + sectionSvg(each, kWidth, report.language) + "<figcaption>" +
                htmlText(each.title) + "</figcaption></figure>\n";
    }
    return text + "</div>\n";
}

std::string strip(const AssessmentReport& report) {
    if (!report.strip) return {};
    constexpr double kWidth = 182, kHeight = 46;  // mm
    std::string text = h2(report, msg::kReportStrip) + stripSvg(*report.strip, kWidth, kHeight, report.language);
    text += "<p class=\"small\">";
    for (std::size_t i = 0; i < report.strip->marks.size(); ++i) {
        text += (i > 0 ? "<br>" : "") + htmlText(markText(i + 1, report.strip->marks[i]));
    }
    return text + "</p>\n";
}

std::string allMetrics(const AssessmentReport& report) {
    std::string text = h2(report, msg::kReportMeasures) + "<table><thead><tr>" + th(report, msg::kHeadMeasure);
    text += th(report, msg::kHeadValue, true) + th(report, msg::kHeadWhere) + th(report, msg::kHeadDefinition);
    text += "</tr></thead><tbody>\n";
    for (const auto& [metric, measured] : report.metrics) {
        if (!measured.value) continue;
        text += "<tr><td>" + htmlText(metric->titleIn(report.language)) + "</td>";
        text += "<td class=\"n\">" + valueText(*metric, *measured.value, report.language) + "</td>";
        text += "<td>" + placeAndMomentText(report, measured) + "</td><td class=\"small\">" +
                htmlText(metric->definitionIn(report.language)) + "</td></tr>\n";
    }
    text += "</tbody></table>\n";
    for (const std::string& each : notMeasuredTexts(report)) text += "<p class=\"small\">" + htmlText(each) + "</p>\n";
    return text;
}

}  // namespace

std::string reportHtml(const AssessmentReport& report) {
    std::string text = pageHead(Message(msg::kReportPage, report.student).in(report.language), kStyle, report.language);
    text += head(report) + madeOf(report) + advice(report) + trend(report) + pictures(report) + sections(report) +
            strip(report) + allMetrics(report);
    text += "<p class=\"small\">" + htmlText(footerText(report)) + "</p>\n</body></html>\n";
    return text;
}

}  // namespace tactooth
