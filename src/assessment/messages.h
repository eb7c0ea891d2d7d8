// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/message.h"

/// The catalogue of this layer: what it says to people, in both languages.
namespace tactooth::msg {

// Exercises.
inline constexpr MessageText kStrokePastTooth{
    "stroke_past_tooth", "stroke %1 of the cavity goes past the tooth; give places over it, in its frame, mm.",
    "窩洞のストローク %1 が歯から外れています。歯の座標系で、歯の上の位置を mm で書いてください。"};
inline constexpr MessageText kBurNotInCatalogue{"bur_not_in_catalogue", "there is no bur %1 in the catalogue.",
                                                "バー %1 はカタログにありません。"};
inline constexpr MessageText kIdealShape{"ideal_shape", "the ideal shape, the whole tooth with its cavity,",
                                         "理想形状（窩洞を含む歯全体）"};

// Files of exercises.
inline constexpr MessageText kAnExercise{"an_exercise", "an exercise", "課題"};
inline constexpr MessageText kDecay{"decay", "decay", "う蝕"};
inline constexpr MessageText kACavity{"a_cavity", "a cavity", "窩洞"};
inline constexpr MessageText kAStroke{"a_stroke", "a stroke", "ストローク"};
inline constexpr MessageText kBuiltinToothHasLayers{
    "builtin_tooth_has_layers", "a built-in tooth brings its own layers", "内蔵の歯には層が含まれています"};
inline constexpr MessageText kDecaySite{
    "decay_site", "'site' must be occlusal, mesial, distal, buccal or lingual",
    "'site' は occlusal、mesial、distal、buccal、lingual のいずれかでなければなりません"};
inline constexpr MessageText kNoOcclusalSide{"no_occlusal_side",
                                             "an anterior tooth has no occlusal side; choose another site",
                                             "前歯には咬合面がありません。別の部位を選んでください"};
inline constexpr MessageText kKeyOfBuiltinTooth{"key_of_builtin_tooth",
                                                "%1 belongs to a built-in tooth, one by its number",
                                                "%1 が使えるのは、番号で指定した内蔵の歯だけです"};
inline constexpr MessageText kBurUnknown{
    "bur_unknown",
    "there is no bur %1 in the catalogue ('tactooth gallery' shows them); a bur of your own is named by its "
    "file, .stl or .toml",
    "バー %1 はカタログにありません（一覧は 'tactooth gallery'）。自分のバーは .stl か .toml "
    "のファイル名で指定します"};
inline constexpr MessageText kIdealShapeUnclear{
    "ideal_shape_unclear",
    "give the ideal shape either by a file, ideal = \"FILE.stl\", or by what the bur cuts, below a line [cavity]",
    "理想の形は、ファイル（ideal = \"FILE.stl\"）か、[cavity] の行の下に書くバーの動きの、"
    "どちらか一方で指定してください"};
inline constexpr MessageText kFloorUnknown{"floor_unknown",
                                           "'floor' must be flat, or surface to follow that of the tooth",
                                           "'floor' は flat か、歯の表面に沿う surface でなければなりません"};
inline constexpr MessageText kNoStrokes{"no_strokes", "there are no strokes; give at least one, [[cavity.strokes]]",
                                        "ストロークがありません。[[cavity.strokes]] を少なくとも一つ書いてください"};
inline constexpr MessageText kTooManyStrokes{"too_many_strokes", "there are too many strokes",
                                             "ストロークが多すぎます"};
inline constexpr MessageText kSideWithoutDirection{"side_without_direction", "'side' has no direction",
                                                   "'side' に向きがありません"};
inline constexpr MessageText kSideUnknown{
    "side_unknown", "'side' must be occlusal, buccal, lingual, mesial, distal, or a direction of three numbers",
    "'side' は occlusal、buccal、lingual、mesial、distal のいずれか、"
    "または三つの数値による向きでなければなりません"};
inline constexpr MessageText kStrokeTooLong{
    "stroke_too_long", "this stroke is longer or farther away than any tooth; places are in mm",
    "このストロークは歯の大きさに対して長すぎるか、遠すぎます。位置の単位は mm です"};

// Built-in exercises.
inline constexpr MessageText kPitInMolar{"pit_in_molar", "Pit in the molar", "臼歯の小窩"};
inline constexpr MessageText kPitTask{
    "pit_task", "Open the central pit 1.5 mm deep, as wide as the bur: down and up again without going aside.",
    "中心小窩をバーの幅のまま深さ 1.5 mm まで開けます。横に動かさず、まっすぐ下ろして戻します。"};
inline constexpr MessageText kClassOne{"class_one", "Class I cavity in the molar", "臼歯の 1 級窩洞"};
inline constexpr MessageText kClassOneTask{
    "class_one_task",
    "Follow the central fissure, 1.5 mm deep and 1.2 mm wide with a flat floor; leave 2 mm of both ridges.",
    "中心溝に沿って深さ 1.5 mm、幅 1.2 mm、窩底を平らに削ります。両側の辺縁隆線は 2 mm 残します。"};
inline constexpr MessageText kClassFive{"class_five", "Class V cavity at the neck of the canine",
                                        "犬歯歯頸部の 5 級窩洞"};
inline constexpr MessageText kClassFiveTask{
    "class_five_task", "At the buccal neck, 1.1 mm deep everywhere: the floor follows the surface of the tooth.",
    "唇側歯頸部を、どこも深さ 1.1 mm で削ります。窩底は歯面に沿わせます。"};

}  // namespace tactooth::msg
