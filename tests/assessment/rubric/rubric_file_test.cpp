// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/rubric/rubric_file.h"

#include <gmock/gmock.h>

namespace tactooth {
namespace {

using ::testing::HasSubstr;

std::string rubricWith(std::string_view line = {}, std::string_view change = {}) {
    std::string text =
        "name = \"Mine\"\n"
        "pass = 60\n"
        "critical_mark = 30\n"
        "[[criterion]]\n"
        "title = \"Depth\"\n"
        "metric = \"floor_depth_median\"\n"
        "weight = 2\n"
        "ideal = [1.5, 2]\n"
        "acceptable = [1.3, 2.2]\n"
        "correct = [1, 2.5]\n"
        "zero = [0.5, 3]\n";
    if (!line.empty()) text.replace(text.find(line), line.size(), change);
    return text;
}

TEST(RubricFile, IsRead) {
    const auto rubric = parseRubric(rubricWith(), "mine.toml");
    ASSERT_TRUE(rubric) << rubric.error().message();
    EXPECT_EQ(rubric->name, "Mine");
    EXPECT_EQ(rubric->passMark, 60);
    EXPECT_EQ(rubric->criticalMark, 30);
    ASSERT_EQ(rubric->criteria.size(), 1U);
    EXPECT_EQ(rubric->criteria[0].title, "Depth");
    EXPECT_EQ(rubric->criteria[0].metric->id, "floor_depth_median");
    EXPECT_EQ(rubric->criteria[0].weight, 2);
    EXPECT_EQ(rubric->criteria[0].levels.scoreOf(2.5), 65);
}

TEST(RubricFile, MayHaveItsWordsInJapanese) {
    const auto own = parseRubric(rubricWith(), "mine.toml");
    ASSERT_TRUE(own);
    EXPECT_EQ(own->nameIn(Language::Japanese), "Mine") << "its own text without others";
    EXPECT_EQ(own->criteria[0].titleIn(Language::Japanese), "Depth");
    const auto given = parseRubric(rubricWith("weight = 2", "weight = 2\njapanese.title = \"深さ\""), "mine.toml");
    ASSERT_TRUE(given) << given.error().message();
    EXPECT_EQ(given->criteria[0].titleIn(Language::Japanese), "深さ");
    EXPECT_EQ(given->criteria[0].titleIn(Language::English), "Depth");
    const auto named = parseRubric("[japanese]\nname = \"x\"\n", "mine.toml");
    EXPECT_THAT(named.error().message(), HasSubstr("'name' is missing"));
    const auto untitled = parseRubric(rubricWith("title = \"Depth\"\n", ""), "mine.toml");
    ASSERT_TRUE(untitled);
    EXPECT_EQ(untitled->criteria[0].titleIn(Language::Japanese), "窩底の深さ（中央値）") << "that of the metric";
}

TEST(RubricFile, MayLeaveOutTheAcceptableRange) {
    const auto rubric = parseRubric(rubricWith("acceptable = [1.3, 2.2]\n", ""), "mine.toml");
    ASSERT_TRUE(rubric) << rubric.error().message();
    // In a straight line from 100 at 2 to 65 at 2.5.
    EXPECT_NEAR(rubric->criteria[0].levels.scoreOf(2.25), 82.5, 1e-9);
}

TEST(RubricFile, IsRefusedWithASentenceThatNamesTheLine) {
    const std::vector<std::array<std::string, 3>> mistakes = {
        {"name = \"Mine\"\n", "", "line 1: the key 'name' is missing"},
        {"pass = 60", "pass = 101", "line 2: 'pass' must be a number from 1 to 100, but is 101"},
        {"pass = 60", "pass = nan", "line 2"},
        {"critical_mark = 30", "critical_mark = 60", "'critical_mark' must be less than 'pass'"},
        {"floor_depth_median", "depth", "line 6: there is no metric 'depth'; docs/assessment.md lists"},
        {"weight = 2", "weight = -1", "line 7: 'weight' must be a number from 0"},
        {"weight = 2", "weight = 0", "line 4: Depth changes no mark"},
        {"weight = 2", "weight = 0\ncritical = true", "no criterion has a weight"},
        {"weight = 2", "wait = 2", "has no key 'wait'"},
        {"ideal = [1.5, 2]", "ideal = 1.5", "line 8: 'ideal' must be a list of 2 numbers"},
        {"ideal = [1.5, 2]", "ideal = [2, 1.5]", "line 4: Depth: each of 'ideal'"},
        {"zero = [0.5, 3]", "zero = [0.5, 2.5]", "must be wider than the one before"},
        {"zero = [0.5, 3]", "zero = [0.5, 1e300]", "line 11: 'zero' must lie between"},
        {"zero = [0.5, 3]", "zero = [0.5, inf]", "line 11"},
        {"zero = [0.5, 3]\n", "", "line 4: the key 'zero' is missing"},
        {"[[criterion]]", "[criterion]", "begin each"},
        {"ideal = [1.5, 2]", "ideal = [[[", "line 9: this is not TOML"},
        {"weight = 2", "japanese = 2", "'japanese'"},
        {"weight = 2", "japanese.name = 'x'", "line 7: a table 'japanese' has no key 'name'"},
    };
    for (const auto& [line, change, sentence] : mistakes) {
        const auto rubric = parseRubric(rubricWith(line, change), "mine.toml");
        ASSERT_FALSE(rubric) << change;
        EXPECT_THAT(rubric.error().message(), HasSubstr(sentence)) << change;
        EXPECT_THAT(rubric.error().message(), ::testing::StartsWith("mine.toml"));
    }
}

TEST(RubricFile, ReadsEachThatIsBuiltIn) {
    EXPECT_GE(builtinRubricTexts().size(), 5U);
    for (const BuiltinRubricText& each : builtinRubricTexts()) {
        const auto rubric = findRubric(each.name);
        ASSERT_TRUE(rubric) << rubric.error().message();
        EXPECT_FALSE(rubric->japaneseName.empty()) << each.name;
        for (const Criterion& criterion : rubric->criteria)
            EXPECT_FALSE(criterion.japaneseTitle.empty()) << each.name << ": " << criterion.title;
    }
    EXPECT_TRUE(findRubric(std::string(kUsualRubric)));
}

void expectSame(const Rubric& written, const Rubric& read) {
    EXPECT_EQ(written.name, read.name);
    EXPECT_EQ(written.japaneseName, read.japaneseName);
    EXPECT_EQ(written.passMark, read.passMark);
    EXPECT_EQ(written.criticalMark, read.criticalMark);
    ASSERT_EQ(written.criteria.size(), read.criteria.size());
    for (std::size_t i = 0; i < written.criteria.size(); ++i) {
        const Criterion &a = written.criteria[i], &b = read.criteria[i];
        EXPECT_EQ(a.title, b.title);
        EXPECT_EQ(a.japaneseTitle, b.japaneseTitle);
        EXPECT_EQ(a.metric, b.metric);
        EXPECT_EQ(a.weight, b.weight);
        EXPECT_EQ(a.levels.ranges(), b.levels.ranges());
        EXPECT_EQ(a.critical, b.critical);
        EXPECT_EQ(a.limitsMark, b.limitsMark);
    }
}

TEST(RubricFile, ReadsBackWhatItWrites) {
    for (const BuiltinRubricText& each : builtinRubricTexts()) {
        const auto rubric = findRubric(each.name);
        ASSERT_TRUE(rubric) << rubric.error().message();
        const auto read = parseRubric(rubricText(*rubric), "written.toml");
        ASSERT_TRUE(read) << read.error().message();
        expectSame(*rubric, *read);
        EXPECT_EQ(rubricText(*rubric), rubricText(*read));
    }
}

TEST(RubricFile, WritesAnyTitleAndNumber) {
    auto rubric = parseRubric(rubricWith(), "mine.toml");
    ASSERT_TRUE(rubric);
    rubric->name = "\"Ours\" \\ 2026 = [1] # 髄室 '''";
    rubric->criteria[0].title = "\\u0041";
    rubric->criteria[0].weight = 1.0 / 3;
    rubric->criteria[0].levels = LevelRanges({{{-1e-7, 0.1}, {-1.0 / 3, 0.1 + 0.2}, {-5e5, 12345.6789}, {-1e6, 1e6}}});
    const auto read = parseRubric(rubricText(*rubric), "written.toml");
    ASSERT_TRUE(read) << read.error().message();
    expectSame(*rubric, *read);
}

TEST(RubricFile, IsFoundByItsName) {
    const auto unknown = findRubric("class-9");
    ASSERT_FALSE(unknown);
    EXPECT_THAT(unknown.error().message(), HasSubstr("there is no rubric 'class-9'"));
    EXPECT_THAT(unknown.error().message(),
                HasSubstr("class-1, class-2, class-3-lingual, class-3, class-5-conservative, class-5, crown-ceramic, "
                          "crown-metal, endodontic-access, fissurotomy, light-hand, near-ideal"));
    const auto missing = findRubric("nowhere/mine.toml");
    ASSERT_FALSE(missing);
    EXPECT_THAT(missing.error().message(), HasSubstr("there is no such file"));
}

}  // namespace
}  // namespace tactooth
