// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/util/message.h"

/// The catalogue of the keys: what each of them does, and what is said about them.
namespace tactooth::msg {

inline constexpr MessageText kKeyGroupCutting{"key_group_cutting", "Touching and cutting", "触診と切削"};
inline constexpr MessageText kKeyGroupView{"key_group_view", "Looking", "見る"};
inline constexpr MessageText kKeyGroupProgram{"key_group_program", "Files and program", "ファイルとプログラム"};
inline constexpr MessageText kKeyGroupReplay{"key_group_replay", "Replay of a recording", "記録のリプレイ"};
inline constexpr MessageText kKeyGroupMouse{"key_group_mouse", "Mouse", "マウス"};
inline constexpr MessageText kKeyGroupPad{"key_group_pad", "Gamepad", "ゲームパッド"};
inline constexpr MessageText kKeyGroupFixed{"key_group_fixed", "Everywhere", "どこでも"};

// Touching and cutting.
inline constexpr MessageText kKeyTouch{"key_touch", "Touch", "触診"};
inline constexpr MessageText kKeyCut{"key_cut", "Cut", "切削"};
inline constexpr MessageText kKeyPedal{"key_pedal", "The pedal, as long as the key is held",
                                       "押している間、ペダルを踏む"};
inline constexpr MessageText kKeyPress{"key_press", "The bur presses, as long as the key is held",
                                       "押している間、バーを押し付ける"};
inline constexpr MessageText kKeyMoveLeft{"key_move_left", "Move the bur to the left", "バーを左へ動かす"};
inline constexpr MessageText kKeyMoveRight{"key_move_right", "Move the bur to the right", "バーを右へ動かす"};
inline constexpr MessageText kKeyMoveUp{"key_move_up", "Move the bur up", "バーを上へ動かす"};
inline constexpr MessageText kKeyMoveDown{"key_move_down", "Move the bur down", "バーを下へ動かす"};
inline constexpr MessageText kKeyLean{"key_lean", "Lean the bur, with the mouse or the keys that move it",
                                      "マウス、またはバーを動かすキーと一緒に：バーを傾ける"};
inline constexpr MessageText kKeyFineDepth{"key_fine_depth", "With the wheel: the depth in steps of 0.02 mm",
                                           "ホイールと一緒に：深さを 0.02 mm ずつ"};
inline constexpr MessageText kKeyUpright{"key_upright", "Stand the bur upright", "バーを垂直にする"};
inline constexpr MessageText kKeyTurnHandleLeft{"key_turn_handle_left", "Turn the handle to the left", "柄を左へ回す"};
inline constexpr MessageText kKeyTurnHandleRight{"key_turn_handle_right", "Turn the handle to the right",
                                                 "柄を右へ回す"};
inline constexpr MessageText kKeyHold{"key_hold", "Hold the bur while the hand of a device moves on",
                                      "装置の手が動く間、バーをその場に保つ"};
inline constexpr MessageText kKeyTakeTurbine{"key_take_turbine", "Take the turbine", "エアタービンを持つ"};
inline constexpr MessageText kKeyTakeContraAngle{"key_take_contra_angle", "Take the electric contra-angle",
                                                 "電動コントラアングルを持つ"};
inline constexpr MessageText kKeyTakeLowSpeed{"key_take_low_speed", "Take the low-speed contra-angle",
                                              "低速コントラアングルを持つ"};
inline constexpr MessageText kKeyTakeExplorer{"key_take_explorer", "Take the explorer", "探針を持つ"};
inline constexpr MessageText kKeyTakeProbe{"key_take_probe", "Take the periodontal probe", "歯周プローブを持つ"};
inline constexpr MessageText kKeyTakeExcavator{"key_take_excavator", "Take the spoon excavator",
                                               "スプーンエキスカベーターを持つ"};
inline constexpr MessageText kKeyWater{"key_water", "Water spray on and off", "注水のオン・オフ"};
inline constexpr MessageText kKeySuction{"key_suction", "Suction on and off", "吸引のオン・オフ"};
inline constexpr MessageText kKeyUndo{"key_undo", "Take back the last cut or change", "最後の切削や変更を取り消す"};
inline constexpr MessageText kKeyRedo{"key_redo", "Do again what was taken back", "取り消したことをもう一度行う"};
inline constexpr MessageText kKeyResetTooth{"key_reset_tooth", "Put back all that was cut", "削ったところをすべて戻す"};

// Looking.
inline constexpr MessageText kKeyTurnTooth{"key_turn_tooth", "Turn the tooth, with the keys that move the bur",
                                           "バーを動かすキーと一緒に：歯を回す"};
inline constexpr MessageText kKeyZoom{"key_zoom", "With the wheel: nearer or farther",
                                      "ホイールと一緒に：近づく、離れる"};
inline constexpr MessageText kKeyNearer{"key_nearer", "Nearer", "近づく"};
inline constexpr MessageText kKeyFarther{"key_farther", "Farther", "離れる"};
inline constexpr MessageText kKeyDentistView{"key_dentist_view", "Dentist's view", "術者の視点"};
inline constexpr MessageText kKeyOcclusal{"key_occlusal", "Occlusal view", "咬合面からの視点"};
inline constexpr MessageText kKeyBuccal{"key_buccal", "Buccal view", "頬側からの視点"};
inline constexpr MessageText kKeyLingual{"key_lingual", "Lingual view", "舌側からの視点"};
inline constexpr MessageText kKeyMesial{"key_mesial", "Mesial view", "近心からの視点"};
inline constexpr MessageText kKeyDistal{"key_distal", "Distal view", "遠心からの視点"};
inline constexpr MessageText kKeyFit{"key_fit", "Show the whole crown", "歯冠全体を表示する"};
inline constexpr MessageText kKeySecondNone{"key_second_none", "No second view", "第2画面なし"};
inline constexpr MessageText kKeySecondOcclusal{"key_second_occlusal", "Second view from occlusal",
                                                "咬合面からの第2画面"};
inline constexpr MessageText kKeySecondBuccal{"key_second_buccal", "Second view from buccal", "頬側からの第2画面"};
inline constexpr MessageText kKeySecondLingual{"key_second_lingual", "Second view from lingual", "舌側からの第2画面"};
inline constexpr MessageText kKeySecondMesial{"key_second_mesial", "Second view from mesial", "近心からの第2画面"};
inline constexpr MessageText kKeySecondDistal{"key_second_distal", "Second view from distal", "遠心からの第2画面"};
inline constexpr MessageText kKeyMirror{"key_mirror", "Mirror on and off", "ミラーの表示のオン・オフ"};
inline constexpr MessageText kKeyHoldMirror{
    "key_hold_mirror",
    "The mouse, or the keys that move the bur, move the mirror, as long as the key is held; with the key that leans "
    "the bur they tilt it, and the wheel, or the keys for nearer and farther, bring it nearer or farther",
    "押している間、マウスかバーを動かすキーでミラーを動かす。バーを傾けるキーと一緒なら傾け、"
    "ホイールか近づく・離れるキーで近づける、離す"};
inline constexpr MessageText kKeyPlaceMirror{"key_place_mirror", "Place the mirror behind the bur",
                                             "バーを後ろから映す位置にミラーを置く"};
inline constexpr MessageText kKeyParkMirror{"key_park_mirror", "Put the mirror back", "ミラーを元に戻す"};
inline constexpr MessageText kKeyDistance{"key_distance", "Measure a distance: click two places; Esc clears, and ends",
                                          "距離を測る：2か所をクリック。Esc で消す、終わる"};
inline constexpr MessageText kKeyAngle{"key_angle",
                                       "Measure the angle between walls: click two places; Esc clears, and ends",
                                       "壁の間の角度を測る：2か所をクリック。Esc で消す、終わる"};
inline constexpr MessageText kKeyTaper{
    "key_taper", "Measure the taper of two opposite walls: click a place on each; Esc clears, and ends",
    "向かい合う壁のテーパーを測る：それぞれをクリック。Esc で消す、終わる"};
inline constexpr MessageText kKeyRemainingDentin{
    "key_remaining_dentin", "Measure the remaining dentin: click a place, and the pulp's distance is shown; Esc ends",
    "残存象牙質の厚さを測る：クリックした所から歯髄までの距離を表示。Esc で終わる"};
inline constexpr MessageText kKeyTurbine{"key_turbine", "Handpiece on and off", "ハンドピースの表示のオン・オフ"};
inline constexpr MessageText kKeyAim{"key_aim", "Aim on and off: landing ring and numbers at the tip",
                                     "照準（触れる位置の輪と先端の数値）のオン・オフ"};
inline constexpr MessageText kKeyGhost{"key_ghost", "The cavity that the target wants cut, on and off",
                                       "目標が求める窩洞の表示のオン・オフ"};
inline constexpr MessageText kKeyGlass{"key_glass", "Glass handpiece on and off", "透けるハンドピースのオン・オフ"};
inline constexpr MessageText kKeyMagnifier{"key_magnifier", "Magnifier of the bur's head on and off",
                                           "バーの頭部の拡大鏡のオン・オフ"};
inline constexpr MessageText kKeyScaleBar{"key_scale_bar", "Scale bar on and off", "目盛りのオン・オフ"};
inline constexpr MessageText kKeySoftTissues{"key_soft_tissues", "Cheeks, lips and tongue on and off",
                                             "頬・口唇・舌の表示のオン・オフ"};
inline constexpr MessageText kKeyLetters{"key_letters", "Letters of the directions on and off",
                                         "方向の文字のオン・オフ"};
inline constexpr MessageText kKeyCube{"key_cube", "View cube on and off", "視点キューブのオン・オフ"};
inline constexpr MessageText kKeyFogged{"key_fogged", "Breath on the mirror", "ミラーの曇り"};
inline constexpr MessageText kKeyDrops{"key_drops", "Drops on the mirror", "ミラーの水滴"};

// Files and program.
inline constexpr MessageText kKeyWelcome{"key_welcome", "Show the exercises and what you worked on last",
                                         "課題と最近の作業を表示"};
inline constexpr MessageText kKeyOpen{"key_open", "Open a tooth", "歯を開く"};
inline constexpr MessageText kKeyImport{"key_import", "Import a scan", "スキャンを取り込む"};
inline constexpr MessageText kKeyChart{"key_chart",
                                       "The tooth chart; there arrow keys, numbers and Enter choose a tooth",
                                       "歯列図。矢印キー、番号、Enter で歯を選ぶ"};
inline constexpr MessageText kKeyBurs{"key_burs",
                                      "The burs; there arrow keys, letters of the search and Enter choose one",
                                      "バーの一覧。矢印キー、検索の文字、Enter で選ぶ"};
inline constexpr MessageText kKeySave{"key_save", "Save the tooth", "歯を保存する"};
inline constexpr MessageText kKeyExport{"key_export", "Export the surface of the cut tooth",
                                        "削った歯の表面を書き出す"};
inline constexpr MessageText kKeyFinish{"key_finish", "Finish the exercise, or go on with it",
                                        "課題を終える、または続ける"};
inline constexpr MessageText kKeyDark{"key_dark", "Dark colours", "暗い配色"};
inline constexpr MessageText kKeyMute{"key_mute", "Mute", "消音"};
inline constexpr MessageText kKeyHelp{"key_help", "Help", "ヘルプ"};
inline constexpr MessageText kKeySettings{"key_settings", "Settings", "設定"};
inline constexpr MessageText kKeyQuit{"key_quit", "Quit", "終了"};

// Replay of a recording.
inline constexpr MessageText kKeyReplayPlay{"key_replay_play", "Play or pause the recording", "記録の再生、一時停止"};
inline constexpr MessageText kKeyReplayPrevious{"key_replay_previous", "To the event or comment before",
                                                "前の出来事かコメントへ"};
inline constexpr MessageText kKeyReplayBack{"key_replay_back", "Back by one tick", "1 ティック戻る"};
inline constexpr MessageText kKeyReplayOn{"key_replay_on", "On by one tick", "1 ティック進む"};
inline constexpr MessageText kKeyReplayNext{"key_replay_next", "To the next event or comment",
                                            "次の出来事かコメントへ"};
inline constexpr MessageText kKeyReplaySideBySide{
    "key_replay_side_by_side", "Two recordings side by side, or no longer", "2つの記録を並べて見る、やめる"};
inline constexpr MessageText kKeyReplayLeave{"key_replay_leave", "Leave the replay", "リプレイを終える"};

// Mouse: what, and its effect.
inline constexpr MessageText kMouseMoveWhat{"mouse_move_what", "Move", "移動"};
inline constexpr MessageText kMouseMove{"mouse_move", "The bur hovers over the point under the mouse",
                                        "マウスの下の点の上にバーが浮く"};
inline constexpr MessageText kMouseLeftWhat{"mouse_left_what", "Left button", "左ボタン"};
inline constexpr MessageText kMouseLeft{"mouse_left",
                                        "The bur goes down to the depth that is set; drag to stroke or cut",
                                        "バーが決めた深さまで下りる。ドラッグでなぞる、削る"};
inline constexpr MessageText kMouseWheelWhat{"mouse_wheel_what", "Wheel", "ホイール"};
inline constexpr MessageText kMouseWheel{"mouse_wheel",
                                         "That depth, in steps of 0.1 mm; by force: press harder or softer",
                                         "その深さを 0.1 mm ずつ。力で押す場合は強く、弱く"};
inline constexpr MessageText kMouseRightWhat{"mouse_right_what", "Right button", "右ボタン"};
inline constexpr MessageText kMouseRight{"mouse_right", "Turn the tooth", "歯を回す"};
inline constexpr MessageText kMouseMiddleWhat{"mouse_middle_what", "Middle button", "中ボタン"};
inline constexpr MessageText kMouseMiddle{"mouse_middle", "Shift the picture", "画面をずらす"};
inline constexpr MessageText kMouseCubeWhat{"mouse_cube_what", "A click on the view cube", "視点キューブのクリック"};
inline constexpr MessageText kMouseCube{"mouse_cube", "Look from that side", "その向きから見る"};

// Gamepad: what, and its effect.
inline constexpr MessageText kPadSticksWhat{"pad_sticks_what", "Sticks", "スティック"};
inline constexpr MessageText kPadSticks{"pad_sticks", "Left: move; right: lean the bur", "左：移動、右：バーを傾ける"};
inline constexpr MessageText kPadLeftWhat{"pad_left_what", "Left trigger, left shoulder", "左トリガー、左ショルダー"};
inline constexpr MessageText kPadLeft{"pad_left", "Press, lift", "押す、持ち上げる"};
inline constexpr MessageText kPadRightWhat{"pad_right_what", "Right trigger, right shoulder",
                                           "右トリガー、右ショルダー"};
inline constexpr MessageText kPadRight{"pad_right", "Pedal, hold the bur", "ペダル、バーの保持"};
inline constexpr MessageText kPadButtonsWhat{"pad_buttons_what", "A, B", "A、B"};
inline constexpr MessageText kPadButtons{"pad_buttons", "Touch or cut, turbine or mirror",
                                         "触診か切削、タービンかミラー"};
inline constexpr MessageText kPadCrossWhat{"pad_cross_what", "D-pad", "十字キー"};
inline constexpr MessageText kPadCross{"pad_cross", "Turn the tooth; with the right shoulder shift the picture",
                                       "歯を回す。右ショルダーと一緒なら画面をずらす"};
inline constexpr MessageText kPadMirrorWhat{"pad_mirror_what", "Y, held", "Y（押している間）"};
inline constexpr MessageText kPadMirror{
    "pad_mirror",
    "The d-pad moves the mirror, with the right shoulder it tilts it; the pressed sticks bring it nearer or farther",
    "十字キーでミラーを動かす、右ショルダーと一緒なら傾ける。スティックの押し込みで近づける、離す"};
inline constexpr MessageText kPadMeasureWhat{"pad_measure_what", "X, while measuring", "X（計測中）"};
inline constexpr MessageText kPadMeasure{"pad_measure", "Mark the place that the tip points at",
                                         "先端が向いている点に印を付ける"};
inline constexpr MessageText kPadPressedWhat{"pad_pressed_what", "Sticks, pressed in", "スティックの押し込み"};
inline constexpr MessageText kPadPressed{"pad_pressed", "Left: farther; right: nearer", "左：離れる、右：近づく"};
inline constexpr MessageText kPadMenusWhat{"pad_menus_what", "Start, Back", "Start、Back"};
inline constexpr MessageText kPadMenus{"pad_menus", "Open the menus; go into the panels, shoulders: the next one",
                                       "メニューを開く、パネルに入る（ショルダーで次のパネル）"};
inline constexpr MessageText kPadFrontWhat{"pad_front_what", "D-pad, A, B in menus, dialogs and panels",
                                           "メニュー、ダイアログ、パネルの中の十字キー、A、B"};
inline constexpr MessageText kPadFront{"pad_front", "Go on, choose, leave", "進む、選ぶ、戻る"};

// Keys that nobody can change: what, and its effect.
inline constexpr MessageText kFixedTabWhat{"fixed_tab_what", "Tab", "Tab"};  // a name
inline constexpr MessageText kFixedTab{"fixed_tab", "Go on to the next control", "次の項目へ移る"};
inline constexpr MessageText kFixedAltWhat{"fixed_alt_what", "Alt + letter", "Alt + 文字"};
inline constexpr MessageText kFixedAlt{"fixed_alt", "Open a menu", "メニューを開く"};
inline constexpr MessageText kFixedEscapeWhat{"fixed_escape_what", "Esc", "Esc"};  // a name
inline constexpr MessageText kFixedEscape{"fixed_escape", "Leave a dialog", "ダイアログを閉じる"};

// The page of the keys.
inline constexpr MessageText kKeyPageTitle{"key_page_title", "Mouse and keys", "マウスとキー"};
inline constexpr MessageText kKeyColumnKey{"key_column_key", "key", "キー"};
inline constexpr MessageText kKeyColumnWhat{"key_column_what", "what it does", "はたらき"};
inline constexpr MessageText kKeyOr{"key_or", "%1 or %2", "%1 か %2"};
inline constexpr MessageText kKeyPageMade{
    "key_page_made", "This page is made by `tactooth manual` from the table of keys; do not edit it.",
    "このページは `tactooth manual` がキーの表から作ります。直接編集しないでください。"};
inline constexpr MessageText kKeyPageChange{
    "key_page_change", "*File > Keys…* changes a key. These are the usual ones.",
    "キーは *File > Keys…*（ファイル > キー…）で変えられます。ここにあるのは最初の設定です。"};
inline constexpr MessageText kKeyPageOwn{"key_page_own",
                                         "*File > Keys…* changes a key. These are the keys as they are now.",
                                         "キーは「ファイル > キー…」で変えられます。ここにあるのは今のキーです。"};

// Why a key cannot be taken.
inline constexpr MessageText kKeyTaken{"key_taken", "%1 is the key of “%2”: give that another key first.",
                                       "%1 は「%2」のキーです。先にそちらのキーを変えてください。"};
inline constexpr MessageText kKeyMovesFocus{"key_moves_focus",
                                            "%1 goes from control to control, and cannot get another meaning.",
                                            "%1 は項目から項目へ移るキーなので、ほかの意味を持たせられません。"};
inline constexpr MessageText kKeyOpensMenus{"key_opens_menus", "%1 opens a menu, and cannot get another meaning.",
                                            "%1 はメニューを開くキーなので、ほかの意味を持たせられません。"};
inline constexpr MessageText kKeyWantsModifier{
    "key_wants_modifier", "This goes with the mouse: hold down Shift, Ctrl, Alt or Meta, not %1.",
    "これはマウスと一緒に使います。%1 ではなく、Shift、Ctrl、Alt、Meta のどれかを押してください。"};
inline constexpr MessageText kKeyUnknown{"key_unknown", "There is no key '%1'.", "'%1' というキーはありません。"};
inline constexpr MessageText kKeyRowUnknown{"key_row_unknown", "There is no action '%1'.",
                                            "'%1' という操作はありません。"};
inline constexpr MessageText kTwoSentences{"two_sentences", "%1 %2", "%1%2"};
inline constexpr MessageText kKeyOwnRefused{"key_own_refused", "Your own keys: %1 The usual key takes its place.",
                                            "自分のキー：%1 最初のキーに戻します。"};

}  // namespace tactooth::msg
