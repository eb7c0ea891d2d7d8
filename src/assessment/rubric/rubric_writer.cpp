// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "assessment/rubric/rubric_file.h"
#include "geometry/util/number_text.h"

namespace tactooth {
namespace {

/// A text in quotes, as TOML wants it.
std::string tomlString(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            result.append({'\\', c});
        } else if (byte < 0x20 || byte == 0x7F) {
            result += fmt::format("\\u{:04X}", byte);
        } else {
            result += c;
        }
    }
    return result + '"';
}

std::string rangeLine(std::string_view key, const LevelRanges::Range& range) {
    return fmt::format("{} = [{}, {}]\n", key, numberText(range.low), numberText(range.high));
}

std::string japaneseLine(std::string_view key, const std::string& words) {
    return words.empty() ? words : fmt::format("japanese.{} = {}\n", key, tomlString(words));
}

std::string criterionText(const Criterion& criterion) {
    const auto& ranges = criterion.levels.ranges();
    std::string text = "\n[[criterion]]\n";
    text += fmt::format("title = {}\n", tomlString(criterion.title));
    text += japaneseLine("title", criterion.japaneseTitle);
    text += fmt::format("metric = {}\n", tomlString(criterion.metric->id));
    if (criterion.weight != 0) text += fmt::format("weight = {}\n", numberText(criterion.weight));
    if (criterion.critical) text += "critical = true\n";
    if (criterion.limitsMark) text += "limits_mark = true\n";
    text += rangeLine("ideal", ranges[0]) + rangeLine("acceptable", ranges[1]);
    return text + rangeLine("correct", ranges[2]) + rangeLine("zero", ranges[3]);
}

}  // namespace

std::string rubricText(const Rubric& rubric) {
    std::string text = fmt::format("name = {}\n", tomlString(rubric.name)) + japaneseLine("name", rubric.japaneseName);
    text +=
        fmt::format("pass = {}\ncritical_mark = {}\n", numberText(rubric.passMark), numberText(rubric.criticalMark));
    for (const Criterion& each : rubric.criteria) text += criterionText(each);
    return text;
}

}  // namespace tactooth
