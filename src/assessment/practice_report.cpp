// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/practice_report.h"

#include <algorithm>

#include "assessment/metric_table.h"
#include "geometry/util/number_text.h"

namespace tactooth {
namespace {

/// A text as one field of a table.
std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + '"';
}

std::string line(std::string_view quantity, double value, std::string_view unit) {
    return std::string(quantity) + ',' + numberText(value) + ',' + std::string(unit) + '\n';
}

std::string linesOf(const CavityProgress& cavity) {
    std::string lines;
    for (const Metric& metric : metricTable()) lines += line(metric.quantity, metric.shown(cavity), metric.shownUnit());
    return lines;
}

}  // namespace

std::string practiceReportCsv(const PracticeReport& report) {
    std::string text = "quantity,value,unit\ntooth," + quoted(report.tooth) + ",\n";
    if (!report.task.empty()) text += "task," + quoted(report.task) + ",\n";
    text += line("time since the first contact", report.seconds, "s");
    if (report.cavity) text += linesOf(*report.cavity);
    for (const MaterialId id : report.materials->ids()) {
        text += line(report.materials->nameOf(id) + " removed", report.removed[static_cast<std::size_t>(id)], "mm^3");
    }
    text += line("of it beside the tooth", report.beside, "mm^3");
    for (const CutEventKind kind : kCutEventKinds) {
        const auto times = std::count_if(report.events.begin(), report.events.end(), [kind](const CutEvent& event) {
            return event.kind == kind && !event.isTakenBack;
        });
        text += line(cutEventName(kind), static_cast<double>(times), "times");
    }
    return text;
}

}  // namespace tactooth
