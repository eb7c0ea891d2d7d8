// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/report/stored_report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "assessment/report/messages.h"
#include "geometry/util/assert.h"
#include "geometry/util/display_text.h"
#include "geometry/util/natural_order.h"

namespace tactooth {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostCriteria = 100;  // as in a rubric
constexpr std::size_t kMostDepth = 20;      // of objects in each other

/// A text without objects in each other that are too deep for the parser.
Json parsed(std::string_view text) {
    const auto isShallow = [](int depth, Json::parse_event_t, Json&) { return depth <= static_cast<int>(kMostDepth); };
    return Json::parse(text, isShallow, false);
}

std::string textAt(const Json& json, const char* key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// A finite number; nothing where there is none.
std::optional<double> numberAt(const Json& json, const char* key) {
    const auto found = json.find(key);
    if (found == json.end() || !found->is_number()) return std::nullopt;
    const auto value = found->get<double>();
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

bool isMark(const std::optional<double>& value) { return value && *value >= 0 && *value <= 100; }

/// All that makes a mark of measures.
Json rangesOf(const Json& report) {
    Json ranges =
        Json::array({report["rubric"].value("pass", Json()), report["rubric"].value("critical_mark", Json())});
    for (const Json& each : report["criteria"]) {
        for (const char* key : {"metric", "weight", "critical", "limits_mark", "ranges"})
            ranges.push_back(each.value(key, Json()));
    }
    return ranges;
}

std::optional<StoredReport::Criterion> criterionOf(const Json& json) {
    if (!json.is_object()) return std::nullopt;
    const std::optional<double> score = numberAt(json, "score");
    StoredReport::Criterion criterion{textAt(json, "metric"), score, numberAt(json, "lost").value_or(0)};
    if (criterion.metric.empty() || (score && !isMark(score))) return std::nullopt;
    return criterion;
}

/// Nothing if the text is no such report.
std::optional<StoredReport> reportOf(const Json& json) {
    if (!json.is_object() || numberAt(json, "format") != kReportFormat) return std::nullopt;
    const auto rubric = json.find("rubric"), criteria = json.find("criteria"), passes = json.find("pass");
    if (rubric == json.end() || !rubric->is_object() || criteria == json.end() || !criteria->is_array() ||
        passes == json.end() || !passes->is_boolean() || criteria->size() > kMostCriteria) {
        return std::nullopt;
    }
    const std::optional<double> mark = numberAt(json, "mark"), passMark = numberAt(*rubric, "pass");
    if (!isMark(mark) || !isMark(passMark)) return std::nullopt;
    StoredReport report{.student = textAt(json, "student"),
                        .name = textAt(json, "name"),
                        .date = textAt(json, "date"),
                        .expert = textAt(json, "expert"),
                        .rubric = textAt(*rubric, "name"),
                        .ranges = {},
                        .passMark = *passMark,
                        .mark = *mark,
                        .passes = passes->get<bool>(),
                        .criteria = {}};
    const Json limiting = json.value("limited_by", Json::array());
    for (const Json& each : *criteria) {
        std::optional<StoredReport::Criterion> criterion = criterionOf(each);
        if (!criterion) return std::nullopt;
        criterion->limitedMark = std::ranges::find(limiting, Json(criterion->metric)) != limiting.end();
        report.criteria.push_back(std::move(*criterion));
    }
    report.ranges = rangesOf(json).dump(-1, ' ', false, Json::error_handler_t::replace);
    return report;
}

}  // namespace

Expected<StoredReport> readStoredReport(std::string_view json, const std::string& name) {
    std::optional<StoredReport> report = reportOf(parsed(json));
    if (!report) return unexpected(msg::kNotAReport, name);
    report->place = name;
    return std::move(*report);
}

StoredReport storedReport(const AssessmentReport& report) {
    std::optional<StoredReport> stored = reportOf(parsed(reportJson(report)));
    TACTOOTH_ASSERT(stored);
    return std::move(*stored);
}

TrialTrend trialTrend(std::span<const StoredReport> reports) {
    TrialTrend trend;
    for (const StoredReport& report : reports) {
        TrialTrend::Trial trial{report.mark, report.passes, {}};
        for (const StoredReport::Criterion& each : report.criteria) {
            const double toAll = each.limitedMark && each.score ? 100 - *each.score : 0;
            trial.scores.push_back({each.score, std::max(each.lost, toAll)});
        }
        trend.trials.push_back(std::move(trial));
    }
    return trend;
}

std::optional<Message> whyNotComparable(const StoredReport& one, const StoredReport& other) {
    if (one.expert != other.expert)
        return Message(msg::kComparedWithOther, one.place, displayText(one.expert), displayText(other.expert));
    if (one.rubric != other.rubric)
        return Message(msg::kMarkedByOther, one.place, displayText(one.rubric), displayText(other.rubric));
    if (one.ranges != other.ranges) return Message(msg::kRubricHasChanged, one.place, displayText(one.rubric));
    return std::nullopt;
}

bool isEarlier(const StoredReport& one, const StoredReport& other) {
    if (one.date != other.date) return one.date < other.date;
    return isNaturallyLess(one.place, other.place);
}

}  // namespace tactooth
