// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/rubric/rubric_file.h"

#include <algorithm>

#include "assessment/messages.h"
#include "geometry/files/file_bytes.h"
#include "geometry/util/number_text.h"
#include "session/io/limited_toml.h"
#include "session/io/messages.h"
#include "session/io/toml_reader.h"

namespace tactooth {
namespace {

constexpr double kLargest = 1e6;  // of an end of a range, in the metric's unit
constexpr double kMostWeight = 1000;
constexpr std::size_t kMostCriteria = 100;
// Without a range for "acceptable", the score falls straight from 100 to 65; it passes 85 here.
constexpr double kAcceptableShare = (100.0 - 85.0) / (100.0 - 65.0);

class RubricReader {
public:
    explicit RubricReader(const std::string& name) : toml_(name) {}

    Expected<Rubric> read(std::string_view text) {
        const toml::table root = toml_.parse(text);
        if (!toml_.error()) readAll(root);
        if (toml_.error()) return Unexpected{*toml_.error()};
        return std::move(rubric_);
    }

private:
    void readAll(const toml::table& root) {
        toml_.allow(root, msg::kARubric, {"name", "japanese", "pass", "critical_mark", "criterion"});
        rubric_.name = toml_.text(root, "name", true);
        rubric_.japaneseName = readJapanese(root, "name");
        rubric_.passMark = toml_.number(root, "pass", rubric_.passMark, 1, 100);
        rubric_.criticalMark = toml_.number(root, "critical_mark", rubric_.criticalMark, 0, 100);
        if (rubric_.criticalMark >= rubric_.passMark) toml_.fail(root, msg::kCriticalMarkPasses);
        const std::vector<const toml::table*> criteria = toml_.tables(root, "criterion");
        if (criteria.empty()) toml_.fail(root, msg::kNoCriteria);
        if (criteria.size() > kMostCriteria) return toml_.fail(root, {msg::kTooManyCriteria, kMostCriteria});
        double weight = 0;
        for (const toml::table* table : criteria) {
            readCriterion(*table);
            if (toml_.error()) return;
            weight += rubric_.criteria.back().weight;
        }
        if (weight <= 0) toml_.fail(root, msg::kNoWeight);
    }

    /// The same word in Japanese; empty without one.
    std::string readJapanese(const toml::table& table, std::string_view key) {
        const toml::table* japanese = toml_.table(table, "japanese");
        if (japanese == nullptr) return {};
        toml_.allow(*japanese, msg::kJapaneseWords, {key});
        return toml_.text(*japanese, key, true);
    }

    void readCriterion(const toml::table& table) {
        toml_.allow(table, msg::kACriterion,
                    {"title", "japanese", "metric", "weight", "ideal", "acceptable", "correct", "zero", "critical",
                     "limits_mark"});
        const std::string id = toml_.text(table, "metric", true);
        const PreparationMetric* metric = findPreparationMetric(id);
        if (metric == nullptr) {
            const toml::node* node = table.get("metric");
            return toml_.fail(node != nullptr ? *node : table, {msg::kMetricUnknown, quotedWord(id)});
        }
        std::string title = toml_.text(table, "title", false);
        std::string japanese = readJapanese(table, "title");
        if (title.empty()) {
            title = metric->title;
            if (japanese.empty()) japanese = metric->titleJa;
        }
        const std::array<LevelRanges::Range, 4> ranges = readRanges(table);
        if (toml_.error()) return;
        if (!LevelRanges::areNested(ranges)) return toml_.fail(table, {msg::kRangesNotNested, title});
        Criterion criterion{std::move(title), metric, 0, LevelRanges(ranges)};
        criterion.weight = toml_.number(table, "weight", 0, 0, kMostWeight);
        criterion.critical = toml_.flag(table, "critical", false);
        criterion.limitsMark = toml_.flag(table, "limits_mark", false);
        criterion.japaneseTitle = std::move(japanese);
        if (criterion.weight == 0 && !criterion.critical && !criterion.limitsMark) {
            return toml_.fail(table, {msg::kCriterionWithoutEffect, criterion.title});
        }
        rubric_.criteria.push_back(std::move(criterion));
    }

    std::array<LevelRanges::Range, 4> readRanges(const toml::table& table) {
        const LevelRanges::Range ideal = range(table, "ideal"), correct = range(table, "correct");
        LevelRanges::Range acceptable{ideal.low + kAcceptableShare * (correct.low - ideal.low),
                                      ideal.high + kAcceptableShare * (correct.high - ideal.high)};
        if (table.get("acceptable") != nullptr) acceptable = range(table, "acceptable");
        return {ideal, acceptable, correct, range(table, "zero")};
    }

    LevelRanges::Range range(const toml::table& table, std::string_view key) {
        const toml::node* node = table.get(key);
        if (node == nullptr) {
            toml_.fail(table, {msg::kKeyMissing, std::string(key)});
            return {};
        }
        std::array<double, 2> ends{};
        toml_.numbers(table, key, ends);
        if (std::max(std::abs(ends[0]), std::abs(ends[1])) > kLargest) {
            toml_.fail(*node, {msg::kRangeTooLarge, quotedWord(key), numberText(kLargest)});
        }
        return {ends[0], ends[1]};
    }

    TomlReader toml_;
    Rubric rubric_;
};

}  // namespace

Expected<Rubric> parseRubric(std::string_view text, const std::string& name) { return RubricReader(name).read(text); }

Expected<Rubric> readRubric(const std::filesystem::path& file) {
    const Expected<FileBytes> bytes = readFile(file, kTomlLimits.bytes);
    if (!bytes) return Unexpected{bytes.error()};
    return parseRubric(bytes->text(), displayName(file));
}

std::string builtinRubricNames() {
    std::string names;
    for (const BuiltinRubricText& each : builtinRubricTexts()) {
        names.append(names.empty() ? "" : ", ").append(each.name);
    }
    return names;
}

Expected<Rubric> findRubric(const std::string& nameOrFile) {
    for (const BuiltinRubricText& each : builtinRubricTexts()) {
        if (nameOrFile == each.name) return parseRubric(each.text, each.name);
    }
    const std::filesystem::path file(nameOrFile);
    if (file.has_extension() || file.has_parent_path()) return readRubric(file);
    return unexpected(msg::kRubricUnknown, quotedWord(nameOrFile), builtinRubricNames());
}

}  // namespace tactooth
