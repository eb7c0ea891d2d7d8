// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/util/message.h"

/// The catalogue of this layer: what it says to people, in both languages.
namespace tactooth::msg {

// What an exercise does not offer.
inline constexpr MessageText kBurNotAllowed{"bur_not_allowed", "This exercise allows other burs only",
                                            "この課題で使えるのは、ほかのバーだけです"};
inline constexpr MessageText kInstrumentNotAllowed{
    "instrument_not_allowed", "This exercise does not allow this instrument", "この課題では、この器具は使えません"};

// Settings of the window.
inline constexpr MessageText kSettingRefused{"setting_refused", "%1, line %2: '%3' must be %4.",
                                             "%1、%2 行目：'%3' の値が誤っています。必要な値：%4。"};
inline constexpr MessageText kNumberFromTo{"number_from_to", "a number from %1 to %2", "%1 から %2 までの数値"};
inline constexpr MessageText kNumberFromToOr{"number_from_to_or", "a number from %1 to %2, or \"%3\"",
                                             "%1 から %2 までの数値、または \"%3\""};
inline constexpr MessageText kOneOfWords{"one_of_words", "one of %1, in quotes", "引用符で囲んだ %1 のどれか"};
inline constexpr MessageText kFlagTakesWord{"flag_takes_word", "%1 takes one of %2, not '%3'.",
                                            "%1 に '%3' は指定できません。%2 のどれかを指定してください。"};
inline constexpr MessageText kFlagTakesYesOrNo{"flag_takes_yes_or_no", "%1 takes yes or no, not '%2'.",
                                               "%1 に '%2' は指定できません。yes か no を指定してください。"};
inline constexpr MessageText kFlagTakesNumber{"flag_takes_number", "%1 takes a number from %2 to %3, not '%4'.",
                                              "%1 に '%4' は指定できません。%2 から %3 までの数値を指定してください。"};
inline constexpr MessageText kFlagTakesNumberOr{
    "flag_takes_number_or", "%1 takes %2 or a number from %3 to %4, not '%5'.",
    "%1 に '%5' は指定できません。%2 か、%3 から %4 までの数値を指定してください。"};
inline constexpr MessageText kDeviceInSetting{"device_in_setting", "'%1' (%2)", "'%1'（%2）"};
inline constexpr MessageText kTwoDevicesForgotten{"two_devices_forgotten", "%1 and no %2", "%1 も %2"};
inline constexpr MessageText kDeviceForgotten{
    "device_forgotten",
    "%1: Tactooth knows no device %2; the usual one takes its place, choose another in the panel Hand.",
    "%1：装置 %2 はありません。いつもの装置を使います。別の装置は「手」パネルで選べます。"};

// Files of the window.
inline constexpr MessageText kPlotFormatUnknown{
    "plot_format_unknown", "the plots cannot be written to %1: end its name in .csv, .svg or .png.",
    "グラフを %1 に書き込めません。名前の最後を .csv、.svg、.png のいずれかにしてください。"};
inline constexpr MessageText kScanHasSurface{
    "scan_has_surface",
    "%1: the tooth has this surface already; drop the files of one tooth, its layers named as in L6_enamel.stl.",
    "%1：この表面はすでにあります。1本の歯のファイルだけをドロップし、層には L6_enamel.stl "
    "のように名前を付けてください。"};

// What a saved tooth carries.
inline constexpr MessageText kNoteExerciseMissing{
    "note_exercise_missing", "the exercise '%1' was not found: put its file beside the tooth, or open it once",
    "演習 '%1' が見つかりません。そのファイルを歯のファイルと同じ場所に置くか、一度開いてください"};
inline constexpr MessageText kNoteTargetMissing{"note_target_missing",
                                                "the target %1 was not found: put it beside the tooth",
                                                "目標 %1 が見つかりません。歯のファイルと同じ場所に置いてください"};

// The window itself.
inline constexpr MessageText kWindowNeedsOpenGl{
    "window_needs_open_gl",
    "the window needs OpenGL 4.1, which this display does not offer; install the graphics driver, or Mesa's "
    "software renderer (package libgl1-mesa-dri).",
    "ウィンドウには OpenGL 4.1 が必要ですが、このディスプレイでは使えません。グラフィックスドライバーか、Mesa "
    "のソフトウェア描画（libgl1-mesa-dri パッケージ）をインストールしてください。"};
inline constexpr MessageText kDisplayGone{"display_gone",
                                          "the display is gone; the device was released, and the settings are kept.",
                                          "ディスプレイとの接続が切れました。手の力は切られ、設定は保存されています。"};

}  // namespace tactooth::msg
