// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/message.h"

/// What the link to tactooth-hand says to people, in both languages.
namespace tactooth::msg {

// Starting the process.
inline constexpr MessageText kHandProgramMissing{
    "hand_program_missing",
    "The program %1, which holds the device, cannot be started (%2): install Tactooth anew, or start it with "
    "--device-in-process.",
    "装置を動かすプログラム %1 を起動できません（%2）。Tactoothをインストールし直すか、--device-in-process "
    "を付けて起動してください。"};
inline constexpr MessageText kHandNoMemory{
    "hand_no_memory", "There is no memory to share with the device's process (%1): close other programs.",
    "装置のプロセスと共有するメモリーを確保できません（%1）。他のプログラムを閉じてください。"};
inline constexpr MessageText kHandOtherVersion{
    "hand_other_version", "%1 belongs to another version of Tactooth: install Tactooth anew.",
    "%1 はTactoothの別のバージョンのものです。Tactoothをインストールし直してください。"};
inline constexpr MessageText kHandEndsAtStart{
    "hand_ends_at_start",
    "The device's process ends while it opens the device (%1): install the device's driver anew, and see 'tactooth "
    "doctor'.",
    "装置を開く間に、装置のプロセスが終了しました（%1）。装置のドライバーを入れ直し、'tactooth doctor' "
    "で確かめてください。"};
inline constexpr MessageText kHandOpensTooLong{
    "hand_opens_too_long", "The device does not open within %1 s: switch it off and on, or restart its driver.",
    "装置が%1秒以内に開きません。電源を入れ直すか、ドライバーを再起動してください。"};

// While a device is open.
inline constexpr MessageText kHandIsGone{
    "hand_is_gone", "The device's process is gone (%1), so the force is off: it is started again every second.",
    "装置のプロセスがなくなったため（%1）、力を切りました。1秒ごとに再起動します。"};
inline constexpr MessageText kHandSignal{"hand_signal", "signal: %1", "シグナル：%1"};
inline constexpr MessageText kHandIsGivenUp{
    "hand_is_given_up",
    "The device's process has ended %1 times (%2), so it stays off: choose the device again, and see 'tactooth "
    "doctor'.",
    "装置のプロセスが%1回終了したため（%2）、停止したままにします。装置を選び直し、'tactooth doctor' "
    "で確かめてください。"};
inline constexpr MessageText kHandIsSilent{
    "hand_is_silent",
    "The device's process answers too slowly, so the force is off: close other programs that keep this machine busy.",
    "装置のプロセスの応答が遅すぎるため、力を切りました。コンピューターに負荷をかけている他のプログラムを"
    "閉じてください。"};
inline constexpr MessageText kHandRefusedForce{
    "hand_refused_force",
    "The device's process has cut the force (%1): lift the bur, and report it to the authors if this comes again.",
    "装置のプロセスが力を切りました（%1）。バーを歯から離してください。繰り返すときは作者に知らせてください。"};
inline constexpr MessageText kHandOtherDevice{"hand_other_device",
                                              "The device that came back has other limits: choose it again.",
                                              "戻った装置の制限値が以前と違います。装置を選び直してください。"};

// Causes, in the fault log and in the sentences above.
inline constexpr MessageText kForceCutByNothing{"force_cut_by_nothing", "no fault", "異常なし"};
inline constexpr MessageText kForceCutNoForce{"force_cut_no_force", "no fresh force for 3 ms",
                                              "3ミリ秒間、新しい力が届きませんでした"};
inline constexpr MessageText kForceCutProgramStopped{"force_cut_program_stopped", "the program was stopped",
                                                     "プログラムが一時停止されました"};
inline constexpr MessageText kForceCutProgramEnded{"force_cut_program_ended",
                                                   "the program ended without closing the device",
                                                   "装置を閉じずにプログラムが終了しました"};
inline constexpr MessageText kForceCutNotANumber{"force_cut_not_a_number", "a force that is no number",
                                                 "力が数値になっていません"};
inline constexpr MessageText kForceCutBeyondLimits{"force_cut_beyond_limits", "a force beyond the device's limits",
                                                   "力が装置の制限を超えました"};
inline constexpr MessageText kForceCutWrongSequence{"force_cut_wrong_sequence", "a force out of its order",
                                                    "力の順序が正しくありません"};
inline constexpr MessageText kForceCutHandHangs{"force_cut_hand_hangs", "the device's process stood still",
                                                "装置のプロセスが動かなくなりました"};
inline constexpr MessageText kForceCutHandKilled{"force_cut_hand_killed", "the device's process was ended by a signal",
                                                 "装置のプロセスがシグナルで終了しました"};
inline constexpr MessageText kForceCutHandStopped{"force_cut_hand_stopped", "the device's process was stopped",
                                                  "装置のプロセスが一時停止されました"};
inline constexpr MessageText kForceCutHandEnded{"force_cut_hand_ended", "the device's process ended by itself",
                                                "装置のプロセスが自ら終了しました"};

}  // namespace tactooth::msg
