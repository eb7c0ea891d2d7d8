// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/message.h"

/// The catalogue of this folder: the words of a report, in both languages.
namespace tactooth::msg {

// Titles.
inline constexpr MessageText kReportTitle{"report_title", "Assessment of a preparation", "形成の評価"};
inline constexpr MessageText kReportPage{"report_page", "Assessment: %1", "評価：%1"};
inline constexpr MessageText kReportMadeOf{"report_made_of", "What the mark is made of", "評点の内訳"};
inline constexpr MessageText kReportNext{"report_next", "What to do next", "次にすること"};
inline constexpr MessageText kReportComment{"report_comment", "The teacher's comment", "教員のコメント"};
inline constexpr MessageText kReportDistance{"report_distance", "Distance to the ideal preparation",
                                             "理想の形成との距離"};
inline constexpr MessageText kReportSections{"report_sections", "Sections", "断面"};
inline constexpr MessageText kReportStrip{"report_strip", "Force and depth during the session",
                                          "セッション中の力と深さ"};
inline constexpr MessageText kReportMeasures{"report_measures", "All measures", "すべての計測値"};

// Lines over the report.
inline constexpr MessageText kFactWork{"fact_work", "Work", "作品"};
inline constexpr MessageText kFactComparedWith{"fact_compared_with", "Compared with", "比較の対象"};
inline constexpr MessageText kFactStudent{"fact_student", "Student", "学生"};
inline constexpr MessageText kFactDate{"fact_date", "Date", "日付"};
inline constexpr MessageText kFactTask{"fact_task", "Task", "課題"};
inline constexpr MessageText kFactRubric{"fact_rubric", "Rubric", "評価基準表"};
inline constexpr MessageText kFactLength{"fact_length", "Length of the session", "セッションの長さ"};
inline constexpr MessageText kFactFit{"fact_fit", "Fit of the surface on the uncut tooth", "削る前の歯との重なり"};
inline constexpr MessageText kFactMinutes{"fact_minutes", "%1 min", "%1（分:秒）"};
inline constexpr MessageText kFactFitValue{"fact_fit_value", "%1 mm RMS over %2 % of it",
                                           "差は %1 mm（RMS、表面の %2 %）"};
inline constexpr MessageText kReportDay{"report_day", "%1-%2-%3 %4 UTC", "%1 年 %2 月 %3 日 %4（UTC）"};

// The mark.
inline constexpr MessageText kOfHundred{"of_hundred", "of 100", "100 点満点"};
inline constexpr MessageText kPassed{"passed", "passed", "合格"};
inline constexpr MessageText kFailed{"failed", "failed", "不合格"};
inline constexpr MessageText kResultOfPassMark{"result_of_pass_mark", "%1, pass mark %2", "%1（合格点 %2）"};
inline constexpr MessageText kNoMark{"no_mark", "No criterion with a weight could be measured, so there is no mark.",
                                     "重みのある評価項目を一つも計測できなかったため、評点はありません。"};
inline constexpr MessageText kWeightedMean{"weighted_mean", "Weighted mean of the scores: %1.", "得点の加重平均：%1。"};
inline constexpr MessageText kWeightedMeanOfPart{
    "weighted_mean_of_part",
    "Weighted mean of the scores: %1 (of %2 % of the weights; the rest could not be measured).",
    "得点の加重平均：%1（重みの %2 % について。残りは計測できませんでした）。"};
inline constexpr MessageText kMarkLimitedBy{"mark_limited_by", "The mark is limited by: %1",
                                            "評点の上限を決めた項目：%1"};

// The heads of tables, and what stands in them.
inline constexpr MessageText kHeadCriterion{"head_criterion", "Criterion", "評価項目"};
inline constexpr MessageText kHeadMeasured{"head_measured", "Measured", "計測値"};
inline constexpr MessageText kHeadScore{"head_score", "Score", "得点"};
inline constexpr MessageText kHeadLevel{"head_level", "Level", "段階"};
inline constexpr MessageText kHeadWeight{"head_weight", "Weight", "重み"};
inline constexpr MessageText kHeadLost{"head_lost", "Lost", "減点"};
inline constexpr MessageText kHeadWhere{"head_where", "Where, when", "位置、時刻"};
inline constexpr MessageText kHeadMeasure{"head_measure", "Measure", "計測項目"};
inline constexpr MessageText kHeadValue{"head_value", "Value", "値"};
inline constexpr MessageText kHeadDefinition{"head_definition", "Definition", "定義"};
inline constexpr MessageText kCriticalCriterion{"critical_criterion", "%1 (critical)", "%1（重大）"};
inline constexpr MessageText kNotMeasurable{"not_measurable", "not measurable", "計測不能"};
inline constexpr MessageText kOnlyLimit{"only_limit", "limit", "上限"};
inline constexpr MessageText kPlaceAndMoment{"place_and_moment", "%1, %2", "%1、%2"};
inline constexpr MessageText kCause{"cause", "%1: %2, %3, cut between %4 and %5 with %6 N.",
                                    "%1：%2、%3。%4 から %5 の間に %6 N で削りました。"};
inline constexpr MessageText kCauseTilted{
    "cause_tilted", "%1: %2, %3, cut between %4 and %5 with %6 N and the bur tilted by %7 degrees.",
    "%1：%2、%3。%4 から %5 の間に、%6 N、バーの傾き %7 度で削りました。"};
inline constexpr MessageText kOverPrepared{"over_prepared", "%1 %2 over-prepared (%3).", "%1：%2 の削りすぎ（%3）。"};
inline constexpr MessageText kOverPreparedBetween{"over_prepared_between",
                                                  "%1 %2 over-prepared (%3) between %4 and %5; force %6 N.",
                                                  "%1：%2 の削りすぎ（%3）。%4 から %5 の間、力 %6 N。"};
inline constexpr MessageText kOverPreparedTilted{
    "over_prepared_tilted", "%1 %2 over-prepared (%3) between %4 and %5; force %6 N, bur tilted %7 degrees.",
    "%1：%2 の削りすぎ（%3）。%4 から %5 の間、力 %6 N、バーの傾き %7 度。"};
inline constexpr MessageText kToSeeIt{"to_see_it", "To see the tooth at that moment: %1",
                                      "その時点の歯を見るコマンド：%1"};
inline constexpr MessageText kMeasuredThere{"measured_there", "%1 (%2)", "%1（%2）"};
inline constexpr MessageText kErrorAt{"error_at", "%1: %2, %3", "%1：%2、%3"};
inline constexpr MessageText kNotMeasured{"not_measured", "Not measurable, because %1: %2.",
                                          "計測できない項目（理由：%1）：%2。"};
inline constexpr MessageText kTwoOfList{"two_of_list", "%1; %2", "%1、%2"};
inline constexpr MessageText kReportFooter{
    "report_footer", "Measures and limits support a teacher's judgement; they do not replace it. Made by %1.",
    "計測値と限度は教員の判断を助けるもので、判断に代わるものではありません。作成：%1。"};

// Drawings.
inline constexpr MessageText kPictureColours{
    "picture_colours",
    "White: within %1 mm of the ideal preparation, or not to be cut. Blue: still to be cut. Orange: cut too deep. The "
    "colours are full from %2 mm on.",
    "白：理想の形成から %1 mm 以内、または削らない部分。青：まだ削るべき部分。橙：削りすぎた部分。色は %2 mm "
    "で最も濃くなります。"};
inline constexpr MessageText kPictureEnlarged{"picture_enlarged", "Enlarged", "拡大"};
inline constexpr MessageText kPictureOcclusal{"picture_occlusal", "Occlusal", "咬合面"};
inline constexpr MessageText kPictureBuccal{"picture_buccal", "Buccal", "頬側"};
inline constexpr MessageText kPictureLingual{"picture_lingual", "Lingual", "舌側"};
inline constexpr MessageText kPictureMesial{"picture_mesial", "Mesial", "近心"};
inline constexpr MessageText kPictureDistal{"picture_distal", "Distal", "遠心"};
inline constexpr MessageText kSectionFromTo{"section_from_to", "Section from %1 to %2", "%1から%2への断面"};
inline constexpr MessageText kSectionAtError{"section_at_error", "%1, at the deepest error",
                                             "%1（最も深い誤りの位置）"};
inline constexpr MessageText kLinePrepared{"line_prepared", "prepared", "形成後"};
inline constexpr MessageText kLineIdeal{"line_ideal", "ideal", "理想"};
inline constexpr MessageText kLineUncut{"line_uncut", "uncut", "形成前"};
inline constexpr MessageText kLinePulp{"line_pulp", "pulp", "歯髄"};
inline constexpr MessageText kStripForce{"strip_force", "force, N", "力 (N)"};
inline constexpr MessageText kStripDepth{"strip_depth", "depth, mm", "深さ (mm)"};

// What to do next.
inline constexpr MessageText kNothingCosts{
    "nothing_costs", "Nothing costs a point: repeat it to be sure, or take a harder exercise.",
    "減点はありません。もう一度行って確かめるか、より難しい課題に進みましょう。"};
inline constexpr MessageText kMoreIsIdeal{"more_is_ideal", "Work on this: %1. It is %2; more would be ideal.",
                                          "「%1」を改善しましょう。現在は %2 で、もっと大きいほうが理想的です。"};
inline constexpr MessageText kLessIsIdeal{"less_is_ideal", "Work on this: %1. It is %2; less would be ideal.",
                                          "「%1」を改善しましょう。現在は %2 で、もっと小さいほうが理想的です。"};

// Trials of one student.
inline constexpr MessageText kReportTrend{"report_trend", "Trials of this exercise", "この課題のこれまでの結果"};
inline constexpr MessageText kTrendInterval{
    "trend_interval",
    "Median mark of the last %1 trials: %2, with 95 % confidence between %3 and %4 (blue). Dashed: the pass mark. "
    "On the right: the criteria that cost most.",
    "直近 %1 回の評点の中央値：%2、95 % 信頼区間 %3 から %4（青）。破線：合格点。右：減点の多い評価項目。"};
inline constexpr MessageText kTrendRange{
    "trend_range",
    "Median mark of the last %1 trials: %2, from %3 to %4. That is too few trials "
    "for a confidence interval, which needs six. Dashed: the pass mark. On the right: the criteria that cost most.",
    "直近 %1 回の評点の中央値：%2（%3 から %4）。信頼区間には 6 "
    "回必要で、まだ回数が足りません。破線：合格点。右：減点の多い評価項目。"};
inline constexpr MessageText kNotAReport{
    "not_a_report",
    "%1: this is no report of an assessment; expected a report.json that 'tactooth assess' has written.",
    "%1：評価の結果ではありません。'tactooth assess' が書いた report.json が必要です。"};
inline constexpr MessageText kComparedWithOther{"compared_with_other",
                                                "%1 is left out: its work was compared with %2, not with %3.",
                                                "%1 は除外しました。作品の比較の対象が %3 ではなく %2 です。"};
inline constexpr MessageText kMarkedByOther{"marked_by_other", "%1 is left out: its rubric is %2, not %3.",
                                            "%1 は除外しました。評価基準表が %3 ではなく %2 です。"};
inline constexpr MessageText kRubricHasChanged{
    "rubric_has_changed", "%1 is left out: the rubric %2 has changed since; assess its work again.",
    "%1 は除外しました。評価基準表 %2 がその後変わっています。作品をもう一度評価してください。"};

// Whether an exercise has been learnt.
inline constexpr MessageText kLearningTitle{"learning_title", "Has it been learnt?", "習得できたか"};
inline constexpr MessageText kLearningPlan{
    "learning_plan",
    "LC-CUSUM: a student who can do it fails %1 % of the trials, and one who cannot %2 %. One who cannot reaches the "
    "limit of %3 within %4 trials with a probability of at most %5 %.",
    "LC-CUSUM：できる学生の不合格率を %1 %、できない学生の不合格率を %2 % とします。できない学生が %4 回以内に限度 %3 "
    "に達する確率は、%5 % 以下です。"};
inline constexpr MessageText kCusumPlan{
    "cusum_plan",
    "CUSUM: %1 % failed trials are acceptable, %2 % are not. The risk of either wrong decision is %3 %. A sum of %4 "
    "says that the rate of failures is not acceptable, one of %5 that it is; then the count begins at 0 again.",
    "CUSUM：不合格率 %1 % は許容でき、%2 % は許容できません。判定を誤る確率はどちらも %3 % です。和が %4 "
    "に達すると許容できない、%5 に達すると許容できると判定し、また 0 から数えます。"};
inline constexpr MessageText kLearningPoints{"learning_points",
                                             "Each point is a trial: green passed, red failed. The limits are dashed.",
                                             "点は各回の結果です（緑：合格、赤：不合格）。破線は限度です。"};
inline constexpr MessageText kLearningChart{"learning_chart", "LC-CUSUM: has it been learnt?",
                                            "LC-CUSUM：習得できたか"};
inline constexpr MessageText kCusumChart{"cusum_chart", "CUSUM: is the rate of failures acceptable?",
                                         "CUSUM：不合格率は許容できるか"};
inline constexpr MessageText kStudentAndExercise{"student_and_exercise", "%1: %2", "%1：%2"};
inline constexpr MessageText kNoName{"no_name", "(no name)", "（名前なし）"};
inline constexpr MessageText kLearntAt{"learnt_at", "Learnt: trial %1 reached the limit (%3 of %2 trials passed).",
                                       "習得しました：%1 回目で限度に達しました（%2 回中 %3 回合格）。"};
inline constexpr MessageText kNotYetLearnt{
    "not_yet_learnt", "Not yet shown (%2 of %1 trials passed): it needs at least %3 more passed trials.",
    "まだ示されていません（%1 回中 %2 回合格）：少なくともあと %3 回の合格が必要です。"};
inline constexpr MessageText kCusumAcceptable{"cusum_acceptable",
                                              "The rate of failures is acceptable; trial %1 has decided it.",
                                              "不合格率は許容できます（%1 回目に判定）。"};
inline constexpr MessageText kCusumUnacceptable{"cusum_unacceptable",
                                                "The rate of failures is not acceptable; trial %1 has decided it.",
                                                "不合格率は許容できません（%1 回目に判定）。"};
inline constexpr MessageText kCusumOpen{"cusum_open",
                                        "The trials do not show yet whether the rate of failures is acceptable.",
                                        "不合格率が許容できるかどうかは、まだ判定できません。"};

// Tables of a class.
inline constexpr MessageText kStudentPage{"student_page", "Trials of %1", "%1 の結果"};
inline constexpr MessageText kClassTitle{"class_title", "Assessment of a class", "クラスの評価"};
inline constexpr MessageText kClassColumns{
    "class_columns", "Rubric: %1, pass mark %2. The columns show the score of each criterion, 0 to 100.",
    "評価基準表：%1、合格点 %2。各列は評価項目の得点（0 から 100）です。"};
inline constexpr MessageText kHeadMark{"head_mark", "Mark", "評点"};
inline constexpr MessageText kHeadResult{"head_result", "Result", "結果"};
inline constexpr MessageText kMeanAndSpread{"mean_and_spread", "Mean ± SD", "平均 ± 標準偏差"};
inline constexpr MessageText kPassedOfAll{"passed_of_all", "%1 of %2 passed", "%2 件中 %1 件合格"};
inline constexpr MessageText kOneTrial{"one_trial", "One trial says little; look at several.",
                                       "一回の結果から言えることはわずかです。数回の結果を見てください。"};

}  // namespace tactooth::msg
