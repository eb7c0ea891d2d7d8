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

// What cannot be measured on a preparation.
inline constexpr MessageText kNothingCut{"nothing_cut", "nothing was cut", "何も削られていません"};
inline constexpr MessageText kNothingToCompare{"nothing_to_compare", "neither of the two surfaces is cut",
                                               "どちらの表面にも削られた部分がありません"};
inline constexpr MessageText kFloorTooNarrow{"floor_too_narrow",
                                             "there is no floor wider than 0.6 mm, without its rounded border",
                                             "丸みのある縁を除くと、幅 0.6 mm を超える窩底がありません"};
inline constexpr MessageText kNoSuchWall{"no_such_wall", "a preparation from this side has no such wall",
                                         "この方向からの形成には、そのような壁がありません"};
inline constexpr MessageText kWallTooSmall{"wall_too_small", "the wall is smaller than 0.5 mm²",
                                           "壁の面積が 0.5 mm² 未満です"};
inline constexpr MessageText kWallTooLow{"wall_too_low",
                                         "the wall is less than 0.6 mm high or wide, without its rounded border",
                                         "丸みのある縁を除くと、壁の高さか幅が 0.6 mm 未満です"};
inline constexpr MessageText kNoCrownPreparation{"no_crown_preparation", "this is a cavity, not a crown preparation",
                                                 "これは窩洞で、支台歯形成ではありません"};
inline constexpr MessageText kNoCavity{"no_cavity", "this is a crown preparation, not a cavity",
                                       "これは支台歯形成で、窩洞ではありません"};
inline constexpr MessageText kNotOcclusal{"not_occlusal", "the cavity is not cut from the occlusal side",
                                          "咬合面からの窩洞ではありません"};
inline constexpr MessageText kNoIsthmus{"no_isthmus", "the cavity is not long enough to have an isthmus",
                                        "窩洞が短く、峡部がありません"};
inline constexpr MessageText kNoRidge{"no_ridge", "the tooth has no outside toward this side",
                                      "歯のこの側には外面がありません"};
inline constexpr MessageText kNoPulpKnown{"no_pulp_known", "the files have no pulp", "ファイルに歯髄がありません"};
inline constexpr MessageText kNoNeighbourKnown{"no_neighbour_known", "the files have no tooth beside",
                                               "ファイルに隣在歯がありません"};

// Rubrics.
inline constexpr MessageText kARubric{"a_rubric", "a rubric", "評価基準表"};
inline constexpr MessageText kACriterion{"a_criterion", "a criterion", "評価項目"};
inline constexpr MessageText kLevelIdeal{"level_ideal", "ideal", "理想"};
inline constexpr MessageText kLevelAcceptable{"level_acceptable", "acceptable", "許容"};
inline constexpr MessageText kLevelCorrect{"level_correct", "to be corrected", "要修正"};
inline constexpr MessageText kLevelFail{"level_fail", "fail", "不合格"};
inline constexpr MessageText kCriticalMarkPasses{"critical_mark_passes",
                                                 "'critical_mark' must be less than 'pass', so that a critical error "
                                                 "fails",
                                                 "重大な誤りが不合格になるように、'critical_mark' は 'pass' "
                                                 "より小さくしてください"};
inline constexpr MessageText kNoCriteria{"no_criteria", "there are no criteria; give at least one, [[criterion]]",
                                         "評価項目がありません。[[criterion]] を少なくとも一つ書いてください"};
inline constexpr MessageText kTooManyCriteria{"too_many_criteria", "there are more than %1 criteria",
                                              "評価項目が %1 個を超えています"};
inline constexpr MessageText kNoWeight{"no_weight", "no criterion has a weight; give one at least a 'weight' over 0",
                                       "重みのある評価項目がありません。0 より大きい 'weight' "
                                       "を少なくとも一つ書いてください"};
inline constexpr MessageText kMetricUnknown{"metric_unknown",
                                            "there is no metric %1; docs/assessment.md lists those that there are",
                                            "%1 という指標はありません。指標の一覧は docs/assessment.md にあります"};
inline constexpr MessageText kRangesNotNested{
    "ranges_not_nested",
    "%1: each of 'ideal', 'acceptable', 'correct' and 'zero' must be wider than the one before; a side without a limit "
    "has the same number in all of them",
    "%1：'ideal'、'acceptable'、'correct'、'zero' は、この順に広くしてください。"
    "限度のない側には、すべて同じ数値を書きます"};
inline constexpr MessageText kRangeTooLarge{"range_too_large", "%1 must lie between -%2 and %2",
                                            "%1 は -%2 から %2 までの範囲で書いてください"};
inline constexpr MessageText kCriterionWithoutEffect{
    "criterion_without_effect", "%1 changes no mark; give it a 'weight', or make it 'critical' or 'limits_mark'",
    "%1 は評点に影響しません。'weight' を書くか、'critical' か 'limits_mark' にしてください"};
inline constexpr MessageText kRubricUnknown{
    "rubric_unknown", "there is no rubric %1; give a file that ends in .toml, or one of %2.",
    "%1 という評価基準表はありません。末尾が .toml のファイルか、%2 のいずれかを指定してください。"};

// Places in a preparation.
inline constexpr MessageText kPlaceMiddle{"place_middle", "in the middle", "中央"};
inline constexpr MessageText kPlaceMesial{"place_mesial", "mesial", "近心"};
inline constexpr MessageText kPlaceDistal{"place_distal", "distal", "遠心"};
inline constexpr MessageText kPlaceBuccal{"place_buccal", "buccal", "頬側"};
inline constexpr MessageText kPlaceLingual{"place_lingual", "lingual", "舌側"};
inline constexpr MessageText kPlaceOcclusal{"place_occlusal", "occlusal", "咬合面側"};
inline constexpr MessageText kPlaceGingival{"place_gingival", "gingival", "歯肉側"};
inline constexpr MessageText kPlaceMesiobuccal{"place_mesiobuccal", "mesiobuccal", "近心頬側"};
inline constexpr MessageText kPlaceMesiolingual{"place_mesiolingual", "mesiolingual", "近心舌側"};
inline constexpr MessageText kPlaceDistobuccal{"place_distobuccal", "distobuccal", "遠心頬側"};
inline constexpr MessageText kPlaceDistolingual{"place_distolingual", "distolingual", "遠心舌側"};
inline constexpr MessageText kPlaceMesioOcclusal{"place_mesio_occlusal", "mesio-occlusal", "近心咬合面側"};
inline constexpr MessageText kPlaceMesiogingival{"place_mesiogingival", "mesiogingival", "近心歯肉側"};
inline constexpr MessageText kPlaceDistoOcclusal{"place_disto_occlusal", "disto-occlusal", "遠心咬合面側"};
inline constexpr MessageText kPlaceDistogingival{"place_distogingival", "distogingival", "遠心歯肉側"};
inline constexpr MessageText kPlaceBuccoOcclusal{"place_bucco_occlusal", "bucco-occlusal", "頬側咬合面側"};
inline constexpr MessageText kPlaceBuccogingival{"place_buccogingival", "buccogingival", "頬側歯肉側"};
inline constexpr MessageText kPlaceLinguoOcclusal{"place_linguo_occlusal", "linguo-occlusal", "舌側咬合面側"};
inline constexpr MessageText kPlaceLinguogingival{"place_linguogingival", "linguogingival", "舌側歯肉側"};

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
