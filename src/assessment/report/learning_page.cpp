// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/report/learning_page.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <tuple>

#include "assessment/report/messages.h"
#include "assessment/report/page_head.h"
#include "assessment/report/svg_text.h"
#include "assessment/report/table_text.h"
#include "geometry/util/display_text.h"

namespace tactooth {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kStyle = R"css(
@page { size: A4; margin: 14mm }
body { font-size: 10pt; line-height: 1.4; color: #1d2730; margin: 0 auto; max-width: 182mm; padding: 6mm }
h1 { font-size: 17pt; margin: 0 0 2mm } p { margin: 1mm 0 } svg { max-width: 100%; height: auto }
h2 { font-size: 11.5pt; margin: 6mm 0 1mm; border-bottom: 0.3mm solid #c9d2d9; padding-bottom: 1mm }
section { page-break-inside: avoid } .small { font-size: 8.5pt; color: #55636f }
)css";

std::string percent(double share) { return fmt::format("{:.4g}", 100 * share); }
std::string rounded(double value) { return fmt::format("{:.2f}", value); }

/// A chart of sums, a point for each trial.
struct Chart {
    std::string title;
    std::vector<double> sums;
    std::vector<double> limits;  ///< that decide
};

std::string chartSvg(const Chart& chart, const std::vector<StoredReport>& trials) {
    constexpr double kWidth = 182, kHeight = 38, kLeft = 10, kTop = 5, kBottom = 33;  // mm
    double least = 0, most = 0;
    for (const auto* values : {&chart.sums, &chart.limits}) {
        for (const double each : *values) {
            least = std::min(least, each);
            most = std::max(most, each);
        }
    }
    const auto count = static_cast<double>(trials.size());
    const auto x = [&](std::size_t i) { return kLeft + (kWidth - kLeft) * (static_cast<double>(i) + 0.5) / count; };
    const auto y = [&](double value) { return kBottom - (kBottom - kTop) * (value - least) / (most - least); };
    std::string svg = svgHead(kWidth, kHeight) + svgText(kLeft, kTop - 1.8, "start", htmlText(chart.title));
    svg += svgLine(kLeft, y(0), kWidth, y(0), "stroke=\"#b8c2ca\" stroke-width=\"0.2\"");
    svg += svgText(kLeft - 1, y(0) + 0.8, "end", "0");
    for (const double limit : chart.limits) {
        svg += svgLine(kLeft, y(limit), kWidth, y(limit),
                       "stroke=\"#1c66b8\" stroke-width=\"0.3\" "
                       "stroke-dasharray=\"1.2 0.8\"");
        svg += svgText(kLeft - 1, y(limit) + 0.8, "end", rounded(limit));
    }
    std::string path;
    for (std::size_t i = 0; i < trials.size(); ++i)
        path += fmt::format("{}{:.2f} {:.2f}", i == 0 ? "M" : "L", x(i), y(chart.sums[i]));
    svg += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"#5d83a8\" stroke-width=\"0.3\"/>\n", path);
    const std::size_t step = (trials.size() - 1) / 25 + 1;
    for (std::size_t i = 0; i < trials.size(); ++i) {
        svg += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"0.9\" fill=\"{}\"/>\n", x(i), y(chart.sums[i]),
                           trials[i].passes ? "#2f7d4f" : "#b23a24");
        if (i % step == 0) svg += svgText(x(i), kHeight - 1, "middle", fmt::format("{}", i + 1));
    }
    return svg + "</svg>\n";
}

std::string planText(const LearningTest& test, Language language) {
    const LearningPlan& plan = test.learning;
    return Message(msg::kLearningPlan, percent(test.adequate), percent(plan.inadequate), rounded(plan.limit),
                   plan.trials, percent(plan.falseAlarm))
        .in(language);
}

std::string cusumText(const LearningTest& test, Language language) {
    return Message(msg::kCusumPlan, percent(test.rates.acceptable), percent(test.rates.unacceptable),
                   percent(test.rates.falseAlarm), rounded(test.cusum.upper), rounded(-test.cusum.lower))
        .in(language);
}

std::string sectionOf(const StudentLearning& student, const LearningTest& test, Language language) {
    const std::string name = student.name.empty() ? std::string(msg::kNoName.in(language)) : student.name;
    const Message title(msg::kStudentAndExercise, displayText(name), displayText(student.trials.back().expert));
    std::string text = "<section><h2>" + htmlText(title.in(language)) + "</h2>\n";
    for (const std::string& each : learningTexts(student, test, language)) text += "<p>" + htmlText(each) + "</p>\n";
    Chart cusum{std::string(msg::kCusumChart.in(language)), {}, {test.cusum.upper, -test.cusum.lower}};
    for (const CusumPoint& each : student.cusum) cusum.sums.push_back(each.sum);
    text += chartSvg({std::string(msg::kLearningChart.in(language)), student.curve.sums, {test.learning.limit}},
                     student.trials);
    return text + chartSvg(cusum, student.trials) + "</section>\n";
}

std::string_view wordOf(CusumDecision decision) {
    return decision == CusumDecision::Acceptable ? "acceptable" : "unacceptable";
}

Json studentJson(const StudentLearning& student) {
    Json json = {{"name", student.name.empty() ? Json() : Json(student.name)},
                 {"expert", student.trials.back().expert},
                 {"rubric", student.trials.back().rubric},
                 {"passed", student.passed()},
                 {"learnt_at", student.curve.learntAt ? Json(*student.curve.learntAt + 1) : Json()},
                 {"trials", Json::array()}};
    for (std::size_t i = 0; i < student.trials.size(); ++i) {
        const StoredReport& trial = student.trials[i];
        const CusumPoint& point = student.cusum[i];
        json["trials"].push_back(
            {{"report", trial.place},
             {"date", trial.date.empty() ? Json() : Json(trial.date)},
             {"mark", trial.mark},
             {"pass", trial.passes},
             {"lc_cusum", student.curve.sums[i]},
             {"cusum", point.sum},
             {"decision", point.decision == CusumDecision::None ? Json() : wordOf(point.decision)}});
    }
    return json;
}

}  // namespace

std::optional<std::size_t> StudentLearning::decidedAt() const {
    for (std::size_t i = cusum.size(); i-- > 0;) {
        if (cusum[i].decision != CusumDecision::None) return i;
    }
    return std::nullopt;
}

std::size_t StudentLearning::passed() const {
    return static_cast<std::size_t>(std::ranges::count(trials, true, &StoredReport::passes));
}

std::vector<StudentLearning> learningOf(const std::vector<StoredReport>& reports, const LearningTest& test) {
    std::map<std::tuple<std::string, std::string, std::string, std::string>, StudentLearning> groups;
    for (const StoredReport& each : reports) {
        StudentLearning& student = groups[{each.name, each.expert, each.rubric, each.ranges}];
        student.name = each.name;
        std::erase_if(student.trials, [&](const StoredReport& other) { return other.isSameWork(each); });
        student.trials.push_back(each);
    }
    std::vector<StudentLearning> students;
    for (auto& [key, student] : groups) {
        std::vector<Trial> trials;
        for (const StoredReport& each : student.trials) trials.push_back(each.passes ? Trial::Passed : Trial::Failed);
        student.cusum = cusumOf(test.cusum, trials);
        student.curve = learningCurve(test.learning, trials);
        students.push_back(std::move(student));
    }
    return students;
}

std::vector<std::string> learningTexts(const StudentLearning& student, const LearningTest& test, Language language) {
    const std::size_t all = student.trials.size();
    std::vector<Message> texts;
    if (student.curve.learntAt) {
        texts.emplace_back(msg::kLearntAt, *student.curve.learntAt + 1, all, student.passed());
    } else {
        const double missing = (test.learning.limit - student.curve.sums.back()) / test.learning.passed;
        texts.emplace_back(msg::kNotYetLearnt, all, student.passed(), static_cast<std::size_t>(std::ceil(missing)));
    }
    const auto decided = student.decidedAt();
    if (!decided) {
        texts.emplace_back(msg::kCusumOpen);
    } else if (student.cusum[*decided].decision == CusumDecision::Acceptable) {
        texts.emplace_back(msg::kCusumAcceptable, *decided + 1);
    } else {
        texts.emplace_back(msg::kCusumUnacceptable, *decided + 1);
    }
    std::vector<std::string> words;
    for (const Message& each : texts) words.push_back(each.in(language));
    return words;
}

std::string learningHtml(const std::vector<StudentLearning>& students, const LearningTest& test, Language language) {
    const std::string_view title = msg::kLearningTitle.in(language);
    std::string text = pageHead(title, kStyle, language) + "<h1>" + htmlText(title) + "</h1>\n";
    for (const std::string& each :
         {planText(test, language), cusumText(test, language), std::string(msg::kLearningPoints.in(language))}) {
        text += "<p class=\"small\">" + htmlText(each) + "</p>\n";
    }
    for (const StudentLearning& each : students) text += sectionOf(each, test, language);
    return text + "</body></html>\n";
}

std::string learningJson(const std::vector<StudentLearning>& students, const LearningTest& test) {
    Json json = {{"format", 1},
                 {"lc_cusum",
                  {{"adequate", test.adequate},
                   {"inadequate", test.learning.inadequate},
                   {"trials", test.learning.trials},
                   {"false_alarm", test.learning.falseAlarm},
                   {"limit", test.learning.limit}}},
                 {"cusum",
                  {{"acceptable", test.rates.acceptable},
                   {"unacceptable", test.rates.unacceptable},
                   {"false_alarm", test.rates.falseAlarm},
                   {"false_trust", test.rates.falseTrust},
                   {"step", test.cusum.step},
                   {"lower", -test.cusum.lower},
                   {"upper", test.cusum.upper}}},
                 {"students", Json::array()}};
    for (const StudentLearning& each : students) json["students"].push_back(studentJson(each));
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace tactooth
