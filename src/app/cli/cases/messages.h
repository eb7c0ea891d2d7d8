// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/util/message.h"

/// The catalogue of this folder: what it says to people, in both languages.
namespace tactooth::msg {

inline constexpr MessageText kPreparedTooth{"prepared_tooth", "the prepared tooth", "形成した歯"};
inline constexpr MessageText kExpertsTooth{"experts_tooth", "the expert's tooth", "熟練者の歯"};
inline constexpr MessageText kNothingToCompareWith{
    "nothing_to_compare_with",
    "there is nothing to compare with; give --expert with a tooth that an expert has prepared, or --exercise.",
    "比べる相手がありません。熟練者が形成した歯を --expert で、または課題を --exercise で指定してください。"};
inline constexpr MessageText kNoUncutTooth{
    "no_uncut_tooth",
    "%1 does not say what the tooth was like before; give the uncut tooth by --original, or an exercise.",
    "%1 には削る前の歯がありません。削る前の歯を --original で指定するか、課題を指定してください。"};
inline constexpr MessageText kLargerThanATooth{
    "larger_than_a_tooth", "%1 is %2 mm large, more than any tooth; give a surface in mm.",
    "%1 の大きさは %2 mm で、どの歯よりも大きいです。mm 単位の表面を指定してください。"};
inline constexpr MessageText kNotInPlace{
    "not_in_place",
    "%1 does not lie on the uncut tooth: outside the preparation they differ by %2 mm (RMS; %3 mm at most) where they "
    "are near, and %4 % of it are; give the same tooth, or --align for a scan in another place.",
    "%1 が削る前の歯と重なりません。形成部以外で近い部分の差は %2 mm（RMS、限度は %3 mm）で、近い部分は全体の %4 % "
    "です。同じ歯を指定するか、位置の違うスキャンなら --align を付けてください。"};
inline constexpr MessageText kNotAligned{
    "not_aligned",
    "%1 cannot be laid on the uncut tooth: outside the preparation they still differ by %2 mm (RMS; %3 mm at most) "
    "where they are near, and %4 % of it are; give a scan of the same tooth, within a few mm and 10 degrees of its "
    "place.",
    "%1 を削る前の歯に重ねられません。形成部以外で近い部分の差は %2 mm（RMS、限度は %3 mm）で、近い部分は全体の %4 % "
    "です。同じ歯のスキャンで、位置のずれが数 mm、傾きが 10 度以内のものを指定してください。"};
inline constexpr MessageText kReplayIsNotTheWork{
    "replay_is_not_the_work",
    "%1: the replay differs from the recording from %2 s on, so this is not the student's tooth; give the saved tooth, "
    "or "
    "use the program that recorded it.",
    "%1：%2 秒以降、再現した内容が記録と異なるため、学生の歯ではありません。保存した歯を指定するか、"
    "記録したプログラムを使ってください。"};

inline constexpr MessageText kNoWorksInFolder{
    "no_works_in_folder",
    "%1: there is no work in this folder; expected recordings (.ttsession), saved teeth (.tactooth) or surfaces (.stl, "
    ".obj, .ply).",
    "%1：このフォルダーには作業結果がありません。記録（.ttsession）、保存した歯（.tactooth）、"
    "または表面（.stl、.obj、.ply）が必要です。"};

inline constexpr MessageText kTwoWorksOfOneName{
    "two_works_of_one_name", "%1: another work has the same name in the marks; name both with their folders there.",
    "%1：採点表で同じ名前になる作業結果がほかにあります。採点表では、両方をフォルダー名とともに書いてください。"};
inline constexpr MessageText kNoWorkHasAMark{
    "no_work_has_a_mark", "%1: none of the works has a mark; the column 'work' must have the names of their files.",
    "%1：どの作業結果にも点数がありません。'work' の列には、ファイルの名前を書いてください。"};

inline constexpr MessageText kEarlierForAFolder{
    "earlier_for_a_folder",
    "--earlier is for the work of one student; in a folder of works, give each student a folder with all the trials.",
    "--earlier "
    "は一人の学生の作品に使います。作品のフォルダーでは、学生ごとのフォルダーにすべての回の作品を入れてください。"};
inline constexpr MessageText kNoEarlierTrial{
    "no_earlier_trial",
    "There is no earlier trial of the same exercise by the same rubric, so the report has no trend.",
    "同じ課題で同じ評価基準表による以前の結果がないため、推移は示されません。"};

inline constexpr MessageText kNoReportsInFolder{
    "no_reports_in_folder", "%1: there is no report.json in this folder; 'tactooth assess' leaves one for each work.",
    "%1：このフォルダーには report.json がありません。'tactooth assess' が作品ごとに書きます。"};
inline constexpr MessageText kTrialsExceedPlan{
    "trials_exceed_plan", "%1 has %2 trials, but %3 are planned; give at least so many by --trials.",
    "%1 の結果は %2 回分ありますが、計画は %3 回です。--trials でそれ以上の回数を指定してください。"};
inline constexpr MessageText kRatesTooClose{
    "rates_too_close",
    "rates of %1 and %2 cannot be distinguished within %3 trials with a false alarm of %4; give rates farther apart "
    "with the lower one first, or more trials.",
    "%1 と %2 の率は、%3 回では誤警報 %4 で区別できません。低いほうを先にして差の大きい率を指定するか、"
    "回数を増やしてください。"};
inline constexpr MessageText kRatesNotInOrder{
    "rates_not_in_order",
    "rates of %1 and %2 are not in order; the acceptable one must be less than the unacceptable one.",
    "%1 と %2 の率の順序が逆です。許容できる率は、許容できない率より小さくしてください。"};

inline constexpr MessageText kNameForAFolder{
    "name_for_a_folder",
    "--name is the name of one student, and a folder has many works; name the files by their students.",
    "--name は一人の学生の名前です。フォルダーには複数の作業結果があるため、ファイルに学生の名前を付けてください。"};

}  // namespace tactooth::msg
