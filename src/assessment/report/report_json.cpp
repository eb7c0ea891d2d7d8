// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <nlohmann/json.hpp>

#include "assessment/report/assessment_report.h"
#include "assessment/report/next_steps.h"

namespace tactooth {
namespace {

using Json = nlohmann::ordered_json;

Json orNull(const std::optional<double>& value) { return value ? Json(*value) : Json(); }
Json orNull(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json placeJson(const AssessmentReport& report, const Measured& measured) {
    if (!measured.place) return {};
    const Vec3& at = *measured.place;
    return {{"x", at.x()}, {"y", at.y()}, {"z", at.z()}, {"name", placeText(report, at, Language::English)}};
}

Json causeJson(const std::optional<RemovalCause>& cause) {
    if (!cause) return {};
    return {{"from", cause->from}, {"to", cause->to}, {"force", cause->force}, {"tilt", orNull(cause->tilt)}};
}

Json errorJson(const AssessmentReport& report, const OverPreparation& error) {
    Json json = {{"wall", error.wall->english}, {"depth", error.depth}, {"volume", error.volume}};
    json["place"] = placeJson(report, Measured::at(error.depth, error.place));
    json["moment"] = orNull(error.moment);
    json["cause"] = causeJson(error.cause);
    json["text"] = overPreparationText(report, error, Language::English);
    return json;
}

/// Adds what was measured to the object of a metric or of a criterion.
void addMeasured(Json& json, const AssessmentReport& report, const PreparationMetric& metric,
                 const Measured& measured) {
    json["value"] = orNull(measured.value);
    json["unit"] = metric.unit;
    json["place"] = placeJson(report, measured);
    json["moment"] = orNull(measured.moment);
    json["cause"] = causeJson(measured.cause);
    if (measured.reason != nullptr) json["reason"] = measured.reason->english;
}

Json criterionJson(const AssessmentReport& report, const CriterionScore& each) {
    const Criterion& criterion = *each.criterion;
    Json json = {{"title", criterion.title}, {"metric", criterion.metric->id}, {"weight", criterion.weight}};
    addMeasured(json, report, *criterion.metric, each.measured);
    json["score"] = orNull(each.score);
    json["level"] = each.level ? Json(levelText(*each.level).english) : Json();
    json["lost"] = each.score ? Json(each.lost) : Json();
    json["critical"] = criterion.critical;
    json["limits_mark"] = criterion.limitsMark;
    Json ranges;
    constexpr std::array<const char*, 4> kNames = {"ideal", "acceptable", "correct", "zero"};
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        const LevelRanges::Range& range = criterion.levels.ranges()[i];
        ranges[kNames[i]] = {range.low, range.high};
    }
    json["ranges"] = std::move(ranges);
    return json;
}

Json trendJson(const TrialTrend& trend) {
    const RecentMarks recent = recentMarks(trend);
    Json marks = Json::array();
    for (const TrialTrend::Trial& each : trend.trials) marks.push_back(each.mark);
    Json json = {{"marks", std::move(marks)}, {"recent", recent.trials}, {"median", recent.median}};
    json["interval"] = recent.interval ? Json{recent.interval->low, recent.interval->high} : Json();
    return json;
}

}  // namespace

std::string reportJson(const AssessmentReport& report) {
    const Rubric& rubric = *report.rubric;
    Json json = {{"format", kReportFormat},
                 {"program", report.program},
                 {"student", report.student},
                 {"expert", report.expert},
                 {"task", orNull(report.task)},
                 {"name", orNull(report.name)},
                 {"date", orNull(report.date)},
                 {"rubric", {{"name", rubric.name}, {"pass", rubric.passMark}, {"critical_mark", rubric.criticalMark}}},
                 {"mark", orNull(report.mark.value)},
                 {"pass", report.mark.passes},
                 {"weighted_mean", orNull(report.mark.weighted)},
                 {"judged_share", report.mark.judgedShare},
                 {"limited_by", Json::array()},
                 {"seconds", orNull(report.seconds)}};
    for (const Criterion* each : report.mark.limitedBy) json["limited_by"].push_back(each->metric->id);
    json["fit"] = report.fit ? Json{{"residual", report.fit->residual}, {"used_share", report.fit->usedShare}} : Json();
    json["next"] = nextSteps(report, Language::English);
    json["comment"] = orNull(report.comment);
    json["trend"] = report.trend ? trendJson(*report.trend) : Json();
    json["errors"] = Json::array();
    for (const OverPreparation& each : report.errors) json["errors"].push_back(errorJson(report, each));
    json["criteria"] = Json::array();
    for (const CriterionScore& each : report.mark.criteria) json["criteria"].push_back(criterionJson(report, each));
    json["metrics"] = Json::array();
    for (const auto& [metric, measured] : report.metrics) {
        Json one = {{"id", metric->id}};
        addMeasured(one, report, *metric, measured);
        json["metrics"].push_back(std::move(one));
    }
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace tactooth
