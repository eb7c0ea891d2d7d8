// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/report/class_report.h"

#include <fmt/core.h>

#include <cmath>

#include "assessment/report/assessment_report.h"
#include "assessment/report/messages.h"
#include "assessment/report/table_text.h"
#include "geometry/util/number_text.h"

namespace tactooth {
namespace {

constexpr std::string_view kStyle = R"css(
@page { size: A4 landscape; margin: 12mm }
body { font: 10pt/1.35 "Noto Sans", "Helvetica Neue", Arial, "Hiragino Sans", "Yu Gothic", "Noto Sans CJK JP",
    "IPAexGothic", "IPAGothic", sans-serif; color: #1d2730; margin: 6mm }
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

/// The page down to the first row of its table.
std::string headOf(const Rubric& rubric, Language language) {
    const std::string_view title = msg::kClassTitle.in(language);
    std::string text =
        fmt::format("<!DOCTYPE html>\n<html lang=\"{}\"><head><meta charset=\"utf-8\"><title>{}</title>\n",
                    languageCode(language), title);
    text += fmt::format("<style>{}</style></head><body>\n<h1>{}</h1>\n", kStyle, title);
    const Message columns(msg::kClassColumns, rubric.nameIn(language), fmt::format("{:.0f}", rubric.passMark));
    text += "<p>" + htmlText(columns.in(language)) + "</p>\n<table><thead><tr>";
    text += fmt::format("<th>{}</th><th class=\"n\">{}</th><th>{}</th>", msg::kFactWork.in(language),
                        msg::kHeadMark.in(language), msg::kHeadResult.in(language));
    for (const Criterion& each : rubric.criteria)
        text += "<th class=\"n\">" + htmlText(each.titleIn(language)) + "</th>";
    return text + "</tr></thead><tbody>\n";
}

}  // namespace

std::string classCsv(const std::vector<ClassRow>& rows, const Rubric& rubric) {
    std::string text = "work,mark,result";
    for (const Criterion& each : rubric.criteria) text += fmt::format(",{0},{0}_score", each.metric->id);
    text += ",note\n";
    for (const ClassRow& row : rows) {
        text += csvCell(row.work) + ',';
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
    std::string text = headOf(rubric, language);
    MeanOf marks;
    std::vector<MeanOf> scores(rubric.criteria.size());
    std::size_t passed = 0;
    for (const ClassRow& row : rows) {
        if (!row.mark) {
            text += fmt::format("<tr><td>{}</td><td class=\"n\">–</td><td colspan=\"{}\">{}</td></tr>\n",
                                htmlText(row.work), 1 + rubric.criteria.size(), htmlText(row.fault.in(language)));
            continue;
        }
        const bool passes = row.mark->passes;
        passed += passes ? 1 : 0;
        marks.add(*row.mark->value);
        text += fmt::format("<tr><td><a href=\"{}/report.html\">{}</a></td><td class=\"n\">{:.1f}</td>",
                            inAddress(row.folder), htmlText(row.work), *row.mark->value);
        text += fmt::format("<td class=\"{}\">{}</td>", passes ? "passed" : "failed",
                            (passes ? msg::kPassed : msg::kFailed).in(language));
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
    return text + fmt::format("</tr></tfoot></table>\n<p class=\"small\">{}</p>\n</body></html>\n",
                              msg::kOneTrial.in(language));
}

}  // namespace tactooth
