// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/report/class_report.h"

#include <fmt/core.h>

#include <cmath>

#include "assessment/report/assessment_report.h"
#include "assessment/report/messages.h"
#include "assessment/report/page_head.h"
#include "assessment/report/table_text.h"
#include "assessment/report/trend_svg.h"
#include "geometry/util/display_text.h"
#include "geometry/util/number_text.h"

namespace tactooth {
namespace {

constexpr std::string_view kStyle = R"css(
@page { size: A4 landscape; margin: 12mm }
body { font-size: 10pt; line-height: 1.35; color: #1d2730; margin: 6mm }
h1 { font-size: 17pt; margin: 0 0 2mm }
table { border-collapse: collapse } tr { page-break-inside: avoid }
th { text-align: left; vertical-align: bottom; font-weight: 600; font-size: 8.5pt; color: #55636f }
td, th { padding: 1mm 3mm 1mm 0; border-bottom: 0.2mm solid #e3e8ec }
td.n, th.n { text-align: right; font-variant-numeric: tabular-nums }
.passed { color: #17603a } .failed { color: #9c2b1a } .small { font-size: 8.5pt; color: #55636f }
tfoot td { border-top: 0.4mm solid #8a97a1; font-weight: 600 }
)css";

/// The name of a folder in an address.
std::string inAddress(std::string_view name) {
    std::string address;
    for (const char c : name) {
        const bool isPlain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '-' ||
                             c == '_' || c == '.';
        address += isPlain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return address;
}

struct MeanOf {
    double sum = 0, squares = 0;
    std::size_t count = 0;

    void add(double value) {
        sum += value;
        squares += value * value;
        ++count;
    }
    [[nodiscard]] std::string text() const {
        if (count == 0) return "–";
        const auto n = static_cast<double>(count);
        if (count == 1) return fmt::format("{:.1f}", sum);
        const double spread = std::sqrt(std::max(0.0, squares - sum * sum / n) / (n - 1));
        return fmt::format("{:.1f} ± {:.1f}", sum / n, spread);
    }
};

std::string cellOf(const CriterionScore& each) {
    if (!each.score) return "<td class=\"n\">–</td>";
    return fmt::format("<td class=\"n\" style=\"color:{}\">{:.0f}</td>", levelColour(*each.level), *each.score);
}

/// The page down to what follows its heading.
std::string headOf(const std::string& title, const Rubric& rubric, Language language) {
    const Message columns(msg::kClassColumns, rubric.nameIn(language), fmt::format("{:.0f}", rubric.passMark));
    return pageHead(title, kStyle, language) + "<h1>" + htmlText(title) + "</h1>\n<p>" +
           htmlText(columns.in(language)) + "</p>\n";
}

std::string linkTo(const std::string& address, const std::string& words) {
    return fmt::format("<a href=\"{}\">{}</a>", address, htmlText(words));
}

/// The work, with links to its report and to the page of its student. `isOfStudent`: the page is that of the student.
std::string workCell(const ClassRow& row, bool isOfStudent) {
    const bool hasPage = !row.student.empty() && !isOfStudent;
    const std::string folder = hasPage ? inAddress(row.student) + "/" : std::string();
    std::string cell = hasPage ? linkTo(folder + "student.html", row.student) + " / " : std::string();
    if (!row.mark) return "<td>" + cell + htmlText(row.work) + "</td>";
    return "<td>" + cell + linkTo(folder + inAddress(row.folder) + "/report.html", row.work) + "</td>";
}

/// The table with a row for each work, and the means.
std::string tableOf(const std::vector<ClassRow>& rows, const Rubric& rubric, bool isOfStudent, Language language) {
    std::string text =
        fmt::format("<table><thead><tr><th>{}</th><th class=\"n\">{}</th><th>{}</th>", msg::kFactWork.in(language),
                    msg::kHeadMark.in(language), msg::kHeadResult.in(language));
    for (const Criterion& each : rubric.criteria)
        text += "<th class=\"n\">" + htmlText(each.titleIn(language)) + "</th>";
    text += "</tr></thead><tbody>\n";
    MeanOf marks;
    std::vector<MeanOf> scores(rubric.criteria.size());
    std::size_t passed = 0;
    for (const ClassRow& row : rows) {
        text += "<tr>" + workCell(row, isOfStudent);
        if (!row.mark) {
            text += fmt::format("<td class=\"n\">–</td><td colspan=\"{}\">{}</td></tr>\n", 1 + rubric.criteria.size(),
                                htmlText(row.fault.in(language)));
            continue;
        }
        const bool passes = row.mark->passes;
        passed += passes ? 1 : 0;
        marks.add(*row.mark->value);
        text += fmt::format("<td class=\"n\">{:.1f}</td><td class=\"{}\">{}</td>", *row.mark->value,
                            passes ? "passed" : "failed", (passes ? msg::kPassed : msg::kFailed).in(language));
        for (std::size_t i = 0; i < row.mark->criteria.size(); ++i) {
            const CriterionScore& each = row.mark->criteria[i];
            if (each.score) scores[i].add(*each.score);
            text += cellOf(each);
        }
        text += "</tr>\n";
    }
    text += fmt::format("</tbody><tfoot><tr><td>{}</td><td class=\"n\">{}</td><td>{}</td>",
                        msg::kMeanAndSpread.in(language), marks.text(),
                        Message(msg::kPassedOfAll, passed, marks.count).in(language));
    for (const MeanOf& each : scores) text += "<td class=\"n\">" + each.text() + "</td>";
    return text + "</tr></tfoot></table>\n";
}

std::string endOf(Language language) {
    return fmt::format("<p class=\"small\">{}</p>\n</body></html>\n", msg::kOneTrial.in(language));
}

}  // namespace

std::string workOf(const ClassRow& row) { return row.student.empty() ? row.work : row.student + "/" + row.work; }

std::string classCsv(const std::vector<ClassRow>& rows, const Rubric& rubric) {
    std::string text = "work,mark,result";
    for (const Criterion& each : rubric.criteria) text += fmt::format(",{0},{0}_score", each.metric->id);
    text += ",note\n";
    for (const ClassRow& row : rows) {
        text += csvCell(workOf(row)) + ',';
        if (row.mark) {
            text += numberText(*row.mark->value) + (row.mark->passes ? ",passed" : ",failed");
            for (const CriterionScore& each : row.mark->criteria) {
                text += ',' + (each.measured.value ? numberText(*each.measured.value) : std::string());
                text += ',' + (each.score ? numberText(*each.score) : std::string());
            }
        } else {
            text += ",not assessed" + std::string(2 * rubric.criteria.size(), ',');
        }
        text += ',' + csvCell(row.fault.in(Language::English)) + '\n';
    }
    return text;
}

std::string classHtml(const std::vector<ClassRow>& rows, const Rubric& rubric, Language language) {
    return headOf(std::string(msg::kClassTitle.in(language)), rubric, language) +
           tableOf(rows, rubric, false, language) + endOf(language);
}

std::string studentHtml(const std::string& student, const std::vector<ClassRow>& rows, const Rubric& rubric,
                        const TrialTrend* trend, Language language) {
    constexpr double kWidth = 182, kHeight = 40;  // mm
    std::string text = headOf(Message(msg::kStudentPage, displayText(student)).in(language), rubric, language);
    if (trend != nullptr) {
        text += trendSvg(*trend, rubric, kWidth, kHeight, language);
        for (const std::string& each : trendTexts(*trend, language)) text += "<p>" + htmlText(each) + "</p>\n";
    }
    return text + tableOf(rows, rubric, true, language) + endOf(language);
}

}  // namespace tactooth
