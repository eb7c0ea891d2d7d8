// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/message.h"

/// The catalogue of this folder: what it says to people, in both languages.
namespace tactooth::msg {

inline constexpr MessageText kStudyNeedsAPlan{
    "study_needs_a_plan",
    "%1: synthetic hands follow the path of a bur, and the ideal of this exercise has none; choose one whose [cavity] "
    "has "
    "strokes, a fissure, an outline or a body.",
    "%1：合成の手はバーの経路をたどりますが、この課題の理想には経路がありません。[cavity] "
    "にストローク、裂溝、外形、組織のいずれかがある課題を選んでください。"};

inline constexpr MessageText kHandExpert{"hand_expert", "Expert", "熟練者"};
inline constexpr MessageText kHandStudent{"hand_student", "Student", "学生"};
inline constexpr MessageText kHandBeginner{"hand_beginner", "Beginner", "初心者"};

inline constexpr MessageText kHabitTremor{"habit_tremor", "Tremor", "振戦"};
inline constexpr MessageText kHabitDelay{"habit_delay", "Delay", "反応の遅れ"};
inline constexpr MessageText kHabitForce{"habit_force", "Force", "力"};
inline constexpr MessageText kHabitLayer{"habit_layer", "Layer in one pass", "一回に削る層"};
inline constexpr MessageText kHabitDeeper{"habit_deeper", "Too deep", "深すぎる量"};
inline constexpr MessageText kHabitWider{"habit_wider", "Too wide", "広すぎる量"};
inline constexpr MessageText kHabitUndone{"habit_undone", "Left undone", "削り残す割合"};
inline constexpr MessageText kHabitUneven{"habit_uneven", "Uneven", "むら"};

inline constexpr MessageText kStudyTitle{"study_title", "Synthetic hands: a self-test of the metrics",
                                         "合成の手による評価項目の自己検査"};
inline constexpr MessageText kStudyMeaning{
    "study_meaning",
    "No person has made these works. A program made them with habits that are known, to see whether the metrics show "
    "the "
    "habits and the marks put the levels in order. It says nothing about real students.",
    "これらの作品は人が作ったものではありません。評価項目が手の癖を示すか、評点が段階を正しく並べるかを調べるため、"
    "決めた癖でプログラムが作りました。実際の学生については何も示しません。"};
inline constexpr MessageText kStudyScene{"study_scene", "Exercise: %1. Rubric: %2. %3 hands of each level, seed %4.",
                                         "課題：%1。評価基準表：%2。各段階の手 %3、乱数の種 %4。"};
inline constexpr MessageText kStudyPassed{
    "study_passed", "Passed: each expert has a better mark than each beginner, and each habit is shown.",
    "合格：どの熟練者の評点もどの初心者より高く、どの癖も示されています。"};
inline constexpr MessageText kStudyFailed{
    "study_failed", "Not passed: %1 of %2 metrics do not show their habit; experts above beginners by mark: %3.",
    "不合格：%2 項目のうち %1 項目が癖を示しません。評点で熟練者が初心者を上回る割合：%3。"};
inline constexpr MessageText kStudyLevels{"study_levels", "Levels", "段階"};
inline constexpr MessageText kStudyLevelsNote{
    "study_levels_note",
    "Medians of the hands of each level. The last column is the share of pairs in which the expert's value is greater "
    "than the beginner's, with its interval of 95 %: 1 and 0 separate them fully, 0.5 not at all.",
    "各段階の手の中央値です。最後の列は、熟練者の値が初心者より大きい組の割合とその 95 % 信頼区間です。1 と 0 "
    "は完全に区別でき、0.5 はまったく区別できません。"};
inline constexpr MessageText kStudyHabits{"study_habits", "Habits", "癖"};
inline constexpr MessageText kStudyHabitsNote{
    "study_habits_note",
    "An expert's hand with four amounts of one habit. The metric must go up (↑) or down (↓) with it; one pair may be "
    "in "
    "the wrong order. What this exercise cannot measure is left out.",
    "熟練者の手で一つの癖だけを四段階に変えました。評価項目は癖とともに上がるか（↑）下がらなければ"
    "（↓）なりません。一組だけは逆でもかまいません。この課題で計測できないものは除きます。"};
inline constexpr MessageText kStudyMetric{"study_metric", "Metric", "評価項目"};
inline constexpr MessageText kStudyHabit{"study_habit", "Habit", "癖"};
inline constexpr MessageText kStudyApart{"study_apart", "Expert over beginner", "熟練者 > 初心者"};
inline constexpr MessageText kStudyShown{"study_shown", "Shown", "示された"};
inline constexpr MessageText kStudyYes{"study_yes", "yes", "はい"};
inline constexpr MessageText kStudyNo{"study_no", "no", "いいえ"};
inline constexpr MessageText kStudyMark{"study_mark", "Mark", "評点"};

}  // namespace tactooth::msg
