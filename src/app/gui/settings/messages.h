// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/util/message.h"

/// The catalogue of the settings: what each of them does, in both languages.
namespace tactooth::msg {

inline constexpr MessageText kOptionAsTheSystem{"option_as_the_system", "as the system", "システムに合わせる"};
inline constexpr MessageText kOptionWindowFolder{"option_window_folder", "Folder that file dialogs open first",
                                                 "ファイルの選択で最初に開くフォルダー"};
inline constexpr MessageText kOptionWindowNotation{"option_window_notation", "Numbers of the teeth in the tooth chart",
                                                   "歯列図の歯の番号"};
inline constexpr MessageText kOptionWindowLanguage{"option_window_language", "Language of the window",
                                                   "ウィンドウの言語"};
inline constexpr MessageText kOptionWindowWelcome{"option_window_welcome",
                                                  "Shows the page with exercises and recent work at each start",
                                                  "起動のたびに、課題と最近の作業のページを表示する"};
inline constexpr MessageText kOptionWindowDark{"option_window_dark", "Dark colours", "暗い配色"};
inline constexpr MessageText kOptionWindowText{"option_window_text", "Size of all texts, as a factor",
                                               "すべての文字の大きさ（倍率）"};
inline constexpr MessageText kOptionWindowTurbine{"option_window_turbine", "Shows the handpiece",
                                                  "ハンドピースを表示する"};
inline constexpr MessageText kOptionWindowMirror{"option_window_mirror", "Shows the mirror", "ミラーを表示する"};
inline constexpr MessageText kOptionWindowAim{"option_window_aim",
                                              "Shows where the bur will land, and the depth at its tip",
                                              "バーが触れる位置と先端の深さを表示する"};
inline constexpr MessageText kOptionWindowSecondView{"option_window_second_view", "Side of the second view",
                                                     "第2画面の向き"};
inline constexpr MessageText kOptionViewGlass{
    "option_view_glass", "Handles turn to glass where they hide the bur's head", "柄がバーの頭部を隠すところで透ける"};
inline constexpr MessageText kOptionViewScaleBar{"option_view_scale_bar", "Scale bar in mm", "mm の目盛り"};
inline constexpr MessageText kOptionViewLetters{
    "option_view_letters", "Letters of the directions at the edge of the picture", "画面の端に方向の文字を出す"};
inline constexpr MessageText kOptionViewCube{
    "option_view_cube", "Cube that shows and chooses the side from which one looks", "見る向きを示し、選べるキューブ"};
inline constexpr MessageText kOptionViewMagnifier{"option_view_magnifier", "Magnifier of the bur's head",
                                                  "バーの頭部の拡大鏡"};
inline constexpr MessageText kOptionViewSoftTissues{"option_view_soft_tissues",
                                                    "Cheeks, lips and tongue around the whole mouth",
                                                    "全顎のまわりに頬・口唇・舌を表示する"};
inline constexpr MessageText kOptionViewSideBySide{
    "option_view_side_by_side", "Shows the second of two recordings beside the first, not as a ghost in it",
    "2つ目の記録を、半透明で重ねずに隣に表示する"};
inline constexpr MessageText kOptionMirrorSize{"option_mirror_size", "Size number of the mirror (18, 22 or 24 mm)",
                                               "ミラーのサイズ番号（18、22、24 mm）"};
inline constexpr MessageText kOptionMirrorFogged{"option_mirror_fogged", "Fog on the mirror's glass", "ミラーの曇り"};
inline constexpr MessageText kOptionMirrorWet{"option_mirror_wet", "Drops on the mirror's glass", "ミラーの水滴"};
inline constexpr MessageText kOptionMirrorDims{
    "option_mirror_dims", "Breath and dirt dim the mirror by themselves, but not in an examination",
    "ミラーが息と汚れで自然に曇る（試験中は曇らない）"};
inline constexpr MessageText kOptionDrillBur{"option_drill_bur", "Bur of the catalogue, by its number",
                                             "カタログのバー（番号で選ぶ）"};
inline constexpr MessageText kOptionDrillFavourites{
    "option_drill_favourites", "Numbers of the favourite burs, as \"4, 245\"", "お気に入りのバーの番号（例：4, 245）"};
inline constexpr MessageText kOptionDrillDrive{"option_drill_drive", "Drive, by its name in the window",
                                               "駆動装置（ウィンドウに出る名前で選ぶ）"};
inline constexpr MessageText kOptionDrillWater{"option_drill_water", "Water spray with the pedal",
                                               "ペダルと一緒に注水する"};
inline constexpr MessageText kOptionDrillSuction{"option_drill_suction", "Suction tube in the mouth", "口の中の吸引管"};
inline constexpr MessageText kOptionForceFromMaterial{
    "option_force_from_material", "Takes stiffness and damping from the material", "剛性と減衰を材質から取る"};
inline constexpr MessageText kOptionForceSpring{"option_force_spring", "Stiffness", "剛性"};
inline constexpr MessageText kOptionForceDamper{"option_force_damper", "Damping", "減衰"};
inline constexpr MessageText kOptionForceFriction{"option_force_friction", "Coulomb coefficient of friction",
                                                  "クーロン摩擦係数"};
inline constexpr MessageText kOptionForceScale{"option_force_scale", "Factor of the force", "力の倍率"};
inline constexpr MessageText kOptionForcePress{
    "option_force_press", "How far the mouse presses beyond the surface (1 mm is about 1 N on enamel)",
    "マウスが表面を越えて押し込む距離（エナメル質では 1 mm がおよそ 1 N）"};
inline constexpr MessageText kOptionForceMouse{"option_force_mouse", "What ends a press of the mouse",
                                               "マウスで押すときに何で止めるか"};
inline constexpr MessageText kOptionForceDepth{"option_force_depth",
                                               "Depth below the uncut surface at which a press of the mouse ends",
                                               "マウスで押すときに止まる、未切削の表面からの深さ"};
inline constexpr MessageText kOptionForceFlatFloor{"option_force_flat_floor",
                                                   "That depth gives a flat floor; else the floor follows the surface",
                                                   "その深さで平らな窩底にする。そうでなければ窩底は表面に沿う"};
inline constexpr MessageText kOptionForceDepthStop{
    "option_force_depth_stop", "A haptic device stops at that depth, too, and pushes back; not in an examination",
    "力覚装置もその深さで止まり、手を押し返す（試験中を除く）"};
inline constexpr MessageText kOptionForceGuide{
    "option_force_guide",
    "A haptic device gently pushes the hand back at the walls of the target; not in an examination",
    "力覚装置が目標の窩壁で手を穏やかに押し戻す（試験中を除く）"};
inline constexpr MessageText kOptionHandDevice{"option_hand_device", "Device that moves the bur", "バーを動かす装置"};
inline constexpr MessageText kOptionHandSecondDevice{"option_hand_second_device",
                                                     "Device of the other hand, which holds the mirror",
                                                     "もう一方の手（ミラーを持つ手）の装置"};
inline constexpr MessageText kOptionHandMotionScaling{
    "option_hand_motion_scaling",
    "Motion scaling: mm that the device moves for each mm of the bur (fit takes it from the workspace of the device)",
    "動きの縮小：バーの 1 mm に対して装置が動く mm（fit は装置の可動域から決める）"};
inline constexpr MessageText kOptionHandRate{"option_hand_rate", "Force updates per second", "力の更新の頻度（毎秒）"};
inline constexpr MessageText kOptionHandLeftHanded{
    "option_hand_left_handed", "Left-handed: handles point to the other side, the sticks of a gamepad are swapped",
    "左利き：柄が反対側を向き、ゲームパッドのスティックが入れ替わる"};
inline constexpr MessageText kOptionHandSwapButton{"option_hand_swap_button",
                                                   "Button that swaps turbine and mirror (0 is none)",
                                                   "タービンとミラーを入れ替えるボタン（0 はなし）"};
inline constexpr MessageText kOptionHandCutButton{"option_hand_cut_button",
                                                  "Button that switches between touch and cut (0 is none)",
                                                  "触診と切削を切り替えるボタン（0 はなし）"};
inline constexpr MessageText kOptionHandClutchButton{"option_hand_clutch_button",
                                                     "Clutch button: holds the bur while the hand moves (0 is none)",
                                                     "クラッチボタン：手が動く間バーを保持する（0 はなし）"};
inline constexpr MessageText kOptionPedalSource{
    "option_pedal_source", "Foot pedal: axis:N or button:N of a joystick, with :NAME of the joystick",
    "フットペダル：ジョイスティックの axis:N か button:N、その後に :NAME（ジョイスティックの名前）"};
inline constexpr MessageText kOptionPedalUp{"option_pedal_up", "Position of that axis without the foot",
                                            "足を離したときのその軸の位置"};
inline constexpr MessageText kOptionPedalDown{"option_pedal_down", "Position of that axis with the pedal pressed fully",
                                              "ペダルをいっぱいに踏んだときのその軸の位置"};
inline constexpr MessageText kOptionPedalKey{"option_pedal_key", "Key that works as the pedal", "ペダルとして働くキー"};
inline constexpr MessageText kOptionSoundTurbine{"option_sound_turbine", "Volume of turbine", "タービンの音量"};
inline constexpr MessageText kOptionSoundCutting{"option_sound_cutting", "Volume of cutting", "切削の音量"};
inline constexpr MessageText kOptionSoundWater{"option_sound_water", "Volume of water and suction", "注水と吸引の音量"};
inline constexpr MessageText kOptionSoundAll{"option_sound_all", "Volume of all sounds", "全体の音量"};
inline constexpr MessageText kOptionSoundMuted{"option_sound_muted", "No sound", "消音"};
inline constexpr MessageText kOptionSoundHeadphones{"option_sound_headphones",
                                                    "Places the sounds around the head, for headphones (HRTF)",
                                                    "ヘッドホン用に、音を頭の周りに配置する（HRTF）"};
inline constexpr MessageText kOptionSoundRoom{"option_sound_room", "Adds the sound of the surgery around the chair",
                                              "診療室の響きを加える"};
inline constexpr MessageText kOptionSoundRecordings{"option_sound_recordings", "File with your own sounds",
                                                    "自分の音のファイル"};
inline constexpr MessageText kOptionRecordingSessions{"option_recording_sessions",
                                                      "Keeps a recording of each session on this computer",
                                                      "各セッションの記録をこのコンピューターに残す"};
inline constexpr MessageText kOptionRecordingGigabytes{"option_recording_gigabytes",
                                                       "Most that all recordings take; the oldest ones go",
                                                       "すべての記録の合計の上限。古いものから消える"};

// The pages of the dialog.
inline constexpr MessageText kSettingsPageAppearance{"settings_page_appearance", "Appearance and language",
                                                     "見た目と言語"};
inline constexpr MessageText kSettingsPageView{"settings_page_view", "View", "表示"};
inline constexpr MessageText kSettingsPageInstruments{"settings_page_instruments", "Instruments", "器具"};
inline constexpr MessageText kSettingsPageForce{"settings_page_force", "Force", "力"};
inline constexpr MessageText kSettingsPageHand{"settings_page_hand", "Hand and devices", "手と装置"};
inline constexpr MessageText kSettingsPageSound{"settings_page_sound", "Sound", "音"};
inline constexpr MessageText kSettingsPageRecording{"settings_page_recording", "Recording and privacy",
                                                    "記録とプライバシー"};

// How the dialog writes values.
inline constexpr MessageText kSettingsWordFit{"settings_word_fit", "fit to the tooth", "歯に合わせる"};
inline constexpr MessageText kSettingsWordOcclusal{"settings_word_occlusal", "occlusal", "咬合面"};
inline constexpr MessageText kSettingsWordBuccal{"settings_word_buccal", "buccal", "頬側"};
inline constexpr MessageText kSettingsWordLingual{"settings_word_lingual", "lingual", "舌側"};
inline constexpr MessageText kSettingsWordMesial{"settings_word_mesial", "mesial", "近心"};
inline constexpr MessageText kSettingsWordDistal{"settings_word_distal", "distal", "遠心"};
inline constexpr MessageText kSettingsWordNone{"settings_word_none", "none", "なし"};
inline constexpr MessageText kSettingsWordDepth{"settings_word_depth", "a depth", "深さ"};
inline constexpr MessageText kSettingsWordForce{"settings_word_force", "the force", "力"};
inline constexpr MessageText kSettingsWordOn{"settings_word_on", "on", "オン"};
inline constexpr MessageText kSettingsWordOff{"settings_word_off", "off", "オフ"};
inline constexpr MessageText kSettingsWordFdi{"settings_word_fdi", "FDI", "FDI"};  // a name
inline constexpr MessageText kSettingsWordUniversal{"settings_word_universal", "Universal", "ユニバーサル"};
inline constexpr MessageText kSettingsWordPalmer{"settings_word_palmer", "Palmer", "パーマー"};

}  // namespace tactooth::msg
