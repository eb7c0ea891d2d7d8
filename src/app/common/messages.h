// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/util/message.h"

/// The catalogue of this layer: what it says to people, in both languages.
namespace tactooth::msg {

// The display.
inline constexpr MessageText kDisplayAdvice{
    "display_advice",
    "%1start it from a desktop or by 'ssh -X' from another computer, or use 'tactooth demo --out DIR', which "
    "needs no display.",
    "%1デスクトップから起動するか、別のコンピューターから 'ssh -X' で起動するか、ディスプレイの要らない "
    "'tactooth demo --out DIR' を使ってください。"};
inline constexpr MessageText kNoWindowOnPlatform{
    "no_window_on_platform", "no window can be opened on Qt's platform '%1'; unset QT_QPA_PLATFORM, ",
    "Qt のプラットフォーム '%1' ではウィンドウを開けません。QT_QPA_PLATFORM の設定を解除し、"};
inline constexpr MessageText kDisplayNotReached{
    "display_not_reached", "the display '%1' (DISPLAY) cannot be reached or refuses the connection; ",
    "ディスプレイ '%1'（DISPLAY）に接続できないか、接続が許可されていないため、"};
inline constexpr MessageText kWaylandNotUsed{
    "wayland_not_used", "the display '%1' (WAYLAND_DISPLAY) cannot be used; install the package qt6-wayland, ",
    "ディスプレイ '%1'（WAYLAND_DISPLAY）を使えません。qt6-wayland パッケージをインストールし、"};
inline constexpr MessageText kNoDisplay{"no_display", "there is no display to open a window on; ",
                                        "ウィンドウを開くディスプレイがないため、"};
inline constexpr MessageText kDisplaySilent{"display_silent", "the display '%1' (%2) does not answer; ",
                                            "ディスプレイ '%1'（%2）が応答しないため、"};

// Plots.
inline constexpr MessageText kPlotTooLarge{"plot_too_large",
                                           "the plot %1 could not be drawn: it does not fit into memory.",
                                           "グラフ %1 を描けませんでした：メモリーに入りきりません。"};
inline constexpr MessageText kNothingToPlot{"nothing_to_plot", "there is nothing to plot: the session has no ticks.",
                                            "描くものがありません。セッションに記録がありません。"};

// Output of any command.
inline constexpr MessageText kOutputLost{"output_lost",
                                         "the output could not be written; check the disk or the pipe that it goes to.",
                                         "出力を書き込めませんでした。出力先のディスクかパイプを確かめてください。"};
inline constexpr MessageText kOutputLostBecause{
    "output_lost_because", "the output could not be written (%1); check the disk or the pipe that it goes to.",
    "出力を書き込めませんでした（%1）。出力先のディスクかパイプを確かめてください。"};
inline constexpr MessageText kUnforeseen{"unforeseen", "this should not have happened: %1; please report it.",
                                         "起こるはずのないことが起こりました：%1。作者に知らせてください。"};
inline constexpr MessageText kUsageHelp{"usage_help", "%1; see '%2 --help'.", "%1。'%2 --help' を参照してください。"};

// Reports.
inline constexpr MessageText kTargetLeavesNothing{
    "target_leaves_nothing",
    "%1 leaves nothing to cut: no part of it lies inside the uncut tooth; choose the same tooth with its cavity, "
    "in the same frame.",
    "%1 には削るところがありません。削る前の歯の内側にある部分がありません。同じ座標系で、"
    "窩洞のある同じ歯を選んでください。"};
inline constexpr MessageText kNothingToJudge{
    "nothing_to_judge", "no criterion of %1 with a weight can be measured on %2; choose another rubric.",
    "%1 の重みのある評価項目は、どれも %2 では測れません。別の評価基準表を選んでください。"};
inline constexpr MessageText kNoPictures{"no_pictures", "There are no pictures: %1", "画像がありません：%1"};

}  // namespace tactooth::msg
