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
inline constexpr MessageText kAFilling{"a_filling", "a filling", "充填物"};
inline constexpr MessageText kFillingMaterial{
    "filling_material", "%1 is no material of a filling; give one of these: %2, or describe it under 'materials'",
    "%1 は充填物の材料ではありません。%2 のどれかを書くか、'materials' の下で定義してください"};
inline constexpr MessageText kStartViewUnknown{
    "start_view_unknown", "'view' must be cavity, dentist, mirror, occlusal, buccal, lingual, mesial or distal",
    "'view' は cavity、dentist、mirror、occlusal、buccal、lingual、mesial、distal のいずれかでなければなりません"};
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

inline constexpr MessageText kJapaneseWords{"japanese_words", "a table 'japanese'", "'japanese' の表"};
inline constexpr MessageText kAFissure{"a_fissure", "a fissure", "裂溝"};
inline constexpr MessageText kABox{"a_box", "a box", "隣接面窩洞"};
inline constexpr MessageText kGroupUnknown{
    "group_unknown",
    "'group' must be hand-eye, caries, filling, class-1, class-2, class-3, class-5, crown, endodontic or own",
    "'group' は hand-eye、caries、filling、class-1、class-2、class-3、class-5、crown、endodontic、own "
    "のいずれかでなければなりません"};
inline constexpr MessageText kInstrumentUnknown{
    "instrument_unknown",
    "'instruments' knows no %1; give some of these: turbine, contra-angle, low-speed, explorer, probe, excavator",
    "'instruments' に %1 は指定できません。turbine、contra-angle、low-speed、explorer、probe、excavator "
    "の中から指定してください"};
inline constexpr MessageText kInstrumentsNeedHandpiece{
    "instruments_need_handpiece", "'instruments' must name at least one handpiece: turbine, contra-angle or low-speed",
    "'instruments' には、ハンドピース（turbine、contra-angle、low-speed）を少なくとも一つ指定してください"};
inline constexpr MessageText kExerciseLevelUnknown{"exercise_level_unknown", "'level' must be easy, usual or hard",
                                                   "'level' は easy、usual、hard のいずれかでなければなりません"};
inline constexpr MessageText kNoSuchRubric{
    "no_such_rubric", "there is no built-in rubric %1; a rubric of your own is named by its file, .toml",
    "内蔵の評価基準表に %1 はありません。自分の評価基準表は .toml のファイル名で指定します"};
inline constexpr MessageText kMouthIsAverage{
    "mouth_is_average", "the whole mouth has average teeth; leave out 'mouth' or 'patient'",
    "口腔全体の歯は平均的な形です。'mouth' か 'patient' のどちらかを外してください"};
inline constexpr MessageText kACrown{"a_crown", "a crown preparation", "支台歯形成"};
inline constexpr MessageText kCrownUnfit{
    "crown_unfit",
    "a crown preparation takes the place of the strokes, and of 'fissure', 'outline', 'boxes' and 'removes'",
    "支台歯形成はストロークの代わりに指定します。'fissure'、'outline'、'boxes'、'removes' とも併用できません"};
inline constexpr MessageText kFinishUnknown{"finish_unknown", "'finish' must be chamfer or shoulder",
                                            "'finish' は chamfer か shoulder でなければなりません"};
inline constexpr MessageText kChamferNeedsRoundEnd{
    "chamfer_needs_round_end",
    "the end of this bur has a radius of %1 mm; a chamfer needs one that is at least as large as its width",
    "このバーの先端の半径は %1 mm です。シャンファーには、その幅以上の半径の先端が必要です"};
inline constexpr MessageText kNoFunctionalCusps{
    "no_functional_cusps",
    "a tooth with an edge has no functional cusps: remove '%1', or give 'occlusal' in place of 'incisal'",
    "切縁のある歯に機能咬頭はありません：'%1' を消すか、'incisal' の代わりに 'occlusal' を書いてください"};
inline constexpr MessageText kOcclusalOrIncisal{
    "occlusal_or_incisal", "give either 'occlusal', for a tooth with cusps, or 'incisal', for one with an edge",
    "咬頭のある歯では 'occlusal'、切縁のある歯では 'incisal' の、どちらか一方を書いてください"};
inline constexpr MessageText kFunctionalSide{"functional_side", "'functional_side' must be buccal or lingual",
                                             "'functional_side' は buccal か lingual でなければなりません"};
inline constexpr MessageText kNoCervicalLine{
    "no_cervical_line",
    "the tooth does not say where its enamel ends; give the height of its cervical line, 'cervical', mm.",
    "エナメル質の終わる所がこの歯では分かりません。歯頸線の高さ 'cervical'（mm）を書いてください。"};
inline constexpr MessageText kFinishLineOffTooth{"finish_line_off_tooth",
                                                 "the finish line leaves the tooth; give it another height.",
                                                 "フィニッシュラインが歯から外れています。高さを変えてください。"};
inline constexpr MessageText kABody{"a_body", "a table 'removes'", "'removes' の表"};
inline constexpr MessageText kTissueUnknown{"tissue_unknown", "'tissue' must be caries, pulp or filling",
                                            "'tissue' は caries、pulp、filling のいずれかでなければなりません"};
inline constexpr MessageText kOpenSideUnknown{
    "open_side_unknown", "'open' must be occlusal, buccal, lingual, mesial or distal",
    "'open' は occlusal、buccal、lingual、mesial、distal のいずれかでなければなりません"};
inline constexpr MessageText kOpenSideUnfit{
    "open_side_unfit", "'open' must name another side than that from which the bur comes, and is not for the pulp",
    "'open' は、バーが入る側とは別の面でなければならず、歯髄には使えません"};
inline constexpr MessageText kBodyUnfit{"body_unfit", "'removes' takes the place of the strokes",
                                        "'removes' はストロークの代わりに指定します"};
inline constexpr MessageText kNoSuchBody{
    "no_such_body",
    "the tooth has no caries, filling or pulp that is wider than the bur, seen from the side of the cavity.",
    "窩洞の側から見て、バーより広いう蝕や充填物、歯髄がこの歯にはありません。"};
inline constexpr MessageText kNoFissureFound{
    "no_fissure_found", "the crown is too short for a cavity between these ridges; leave less of them.",
    "この辺縁隆線を残すと、窩洞を入れる長さが歯冠にありません。残す量を減らしてください。"};
inline constexpr MessageText kNoFissure{"no_fissure", "this tooth has no fissure to follow",
                                        "この歯には、たどる裂溝がありません"};
inline constexpr MessageText kFissureUnfit{
    "fissure_unfit", "a fissure takes the place of the strokes, from the occlusal side with a flat floor",
    "裂溝はストロークの代わりに指定します。咬合面からの平らな窩底に限ります"};
inline constexpr MessageText kOutlineNeedsBur{"outline_needs_bur",
                                              "an outline that is found on the tooth needs a bur of the catalogue",
                                              "歯の形から求める外形には、カタログのバーが必要です"};
inline constexpr MessageText kBoxWithoutFissure{
    "box_without_fissure",
    "a box ends a cavity along a fissure or below an outline; give [cavity.fissure] or [cavity.outline]",
    "隣接面窩洞は、裂溝に沿う窩洞か、外形のある窩洞の端に付きます。[cavity.fissure] か [cavity.outline] "
    "を書いてください"};
inline constexpr MessageText kAnOutline{"an_outline", "an outline", "外形"};
inline constexpr MessageText kAForbiddenZone{"a_forbidden_zone", "a table 'forbidden'", "'forbidden' の表"};
inline constexpr MessageText kOutlineUnfit{"outline_unfit", "an outline takes the place of strokes and of 'removes'",
                                           "外形は、ストロークや 'removes' の代わりに指定します"};
inline constexpr MessageText kBoxUnfit{"box_unfit", "a box needs a cavity from the occlusal side with a flat floor",
                                       "隣接面窩洞が付くのは、咬合面からの、窩底の平らな窩洞だけです"};
inline constexpr MessageText kCornersNeeded{
    "corners_needed", "'corners' must be a list of 3 to %1 places, each [x, y, z] in mm near the tooth",
    "'corners' は 3 個から %1 個までの位置の並びで、それぞれ歯の近くの [x, y, z]（mm）でなければなりません"};
inline constexpr MessageText kDrawnOutlineTooLarge{"drawn_outline_too_large",
                                                   "this outline is larger than any tooth; places are in mm",
                                                   "この外形はどの歯よりも大きいです。位置の単位は mm です"};
inline constexpr MessageText kDrawnOutlineCrosses{"drawn_outline_crosses",
                                                  "the outline crosses itself, seen from its side",
                                                  "外形が、その向きから見て自分自身と交わっています"};
inline constexpr MessageText kTooManyZones{"too_many_zones", "there are more than %1 tables 'forbidden'",
                                           "'forbidden' の表が %1 個を超えています"};
inline constexpr MessageText kPlaceTooFar{"place_too_far", "this place is far away from any tooth; places are in mm",
                                          "この位置は歯から遠すぎます。位置の単位は mm です"};
inline constexpr MessageText kDecaySiteOrPlace{"decay_site_or_place",
                                               "decay has either a 'site' or a place, 'at', not both",
                                               "う蝕には 'site' か位置 'at' のどちらか一方を書いてください"};
inline constexpr MessageText kDecaySpread{
    "decay_spread", "'spread' must be a list of 1 to %1 places [x, y, z] near the tooth, mm",
    "'spread' は歯の近くの位置 [x, y, z] (mm) を 1 から %1 個並べたものでなければなりません"};
inline constexpr MessageText kDecaySpreadNeedsPlace{"decay_spread_needs_place",
                                                    "decay that has 'spread' begins at a place, 'at'",
                                                    "'spread' を書くときは、う蝕の位置を 'at' で書いてください"};
inline constexpr MessageText kARim{"a_rim", "the rim of decay", "う蝕の周囲の層"};
inline constexpr MessageText kRimMaterial{
    "rim_material", "%1 is no material of a rim; give one of these: %2, or describe it under 'materials'",
    "%1 は周囲の層の材料ではありません。%2 のどれかを書くか、'materials' の下で定義してください"};
inline constexpr MessageText kRimNesting{
    "rim_nesting", "the material '%1' of a rim needs a 'nesting' from %2 (dentin) to below %3 (pulp)",
    "周囲の層の材料 '%1' の 'nesting' は %2 (象牙質) 以上 %3 (歯髄) 未満でなければなりません"};
inline constexpr MessageText kNoRoomInOutline{
    "no_room_in_outline",
    "the outline is narrower than the bur, lies beside the tooth, or does not reach its box; draw it anew.",
    "外形がバーより狭いか、歯から外れているか、隣接面窩洞に届いていません。描き直してください。"};
inline constexpr MessageText kMustLieInFolder{"must_lie_in_folder",
                                              "%1 must lie in the folder of the exercise, %2, or below it; save it "
                                              "there.",
                                              "%1 は課題のフォルダー %2 かその下に置く必要があります。"
                                              "課題をそのフォルダーに保存してください。"};
inline constexpr MessageText kBoxTwice{"box_twice", "there is already a box on this side",
                                       "この側には、すでに隣接面窩洞があります"};
inline constexpr MessageText kBoxSide{"box_side", "'side' of a box must be mesial or distal",
                                      "隣接面窩洞の 'side' は mesial か distal でなければなりません"};
inline constexpr MessageText kRidgeOrBox{
    "ridge_or_box", "each end of a fissure has either a box or '%1', the tooth that is left there, mm",
    "裂溝の両端には、隣接面窩洞か、そこに残す歯の厚み '%1'（mm）の、どちらか一方を書いてください"};
inline constexpr MessageText kExerciseUnknown{
    "exercise_unknown", "there is no exercise %1; give a file that ends in .toml, or one of %2.",
    "%1 という課題はありません。末尾が .toml のファイルか、%2 のいずれかを指定してください。"};

// Lists of exercises.
inline constexpr MessageText kGroupHandEye{"group_hand_eye", "Hand and eye", "手と目の協調"};
inline constexpr MessageText kGroupCaries{"group_caries", "Removal of caries", "う蝕の除去"};
inline constexpr MessageText kGroupFilling{"group_filling", "Removal of fillings", "充填物の除去"};
inline constexpr MessageText kGroupClassOne{"group_class_one", "Class I", "1 級窩洞"};
inline constexpr MessageText kGroupClassTwo{"group_class_two", "Class II", "2 級窩洞"};
inline constexpr MessageText kGroupClassThree{"group_class_three", "Class III", "3 級窩洞"};
inline constexpr MessageText kGroupClassFive{"group_class_five", "Class V", "5 級窩洞"};
inline constexpr MessageText kGroupCrown{"group_crown", "Crown", "支台歯形成"};
inline constexpr MessageText kGroupEndodontic{"group_endodontic", "Endodontic access", "髄室開拡"};
inline constexpr MessageText kGroupOwn{"group_own", "Your own", "自作の課題"};
inline constexpr MessageText kLevelEasy{"level_easy", "easy", "易しい"};
inline constexpr MessageText kLevelUsual{"level_usual", "usual", "普通"};
inline constexpr MessageText kLevelHard{"level_hard", "hard", "難しい"};

// What cannot be measured on a preparation.
inline constexpr MessageText kNothingCut{"nothing_cut", "nothing was cut", "何も削られていません"};
inline constexpr MessageText kNothingToCompare{"nothing_to_compare", "neither of the two surfaces is cut",
                                               "どちらの表面にも削られた部分がありません"};
inline constexpr MessageText kNoFloor{"no_floor", "nothing larger than 0.05 mm² faces the axis within 45 degrees",
                                      "軸から 45 度以内を向く、0.05 mm² を超える面がありません"};
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
inline constexpr MessageText kNoOcclusalEnd{"no_occlusal_end", "the stump has no end wider than 0.6 mm that faces up",
                                            "支台歯に、上を向いた幅 0.6 mm を超える面がありません"};
inline constexpr MessageText kNoInnerAngle{"no_inner_angle", "there is no angle between a floor and a wall",
                                           "窩底と側壁の間の隅角がありません"};
inline constexpr MessageText kNoGumKnown{"no_gum_known", "the files have no gum", "ファイルに歯肉がありません"};
inline constexpr MessageText kNoPulpKnown{"no_pulp_known", "the files have no pulp", "ファイルに歯髄がありません"};
inline constexpr MessageText kNoNeighbourKnown{"no_neighbour_known", "the files have no tooth beside",
                                               "ファイルに隣在歯がありません"};
inline constexpr MessageText kNoNeighbourThere{"no_neighbour_there", "no tooth stands within 3 mm of the box",
                                               "窩洞の隣接面から 3 mm 以内に歯がありません"};
inline constexpr MessageText kNoBox{"no_box", "neither of the two preparations has a proximal box",
                                    "どちらの形成にも隣接面窩洞がありません"};
inline constexpr MessageText kNoForbiddenZone{"no_forbidden_zone", "the exercise has no forbidden zone",
                                              "この課題に切削禁止域はありません"};
inline constexpr MessageText kNoTissueKnown{"no_tissue_known", "the files do not say what is enamel and dentin",
                                            "ファイルにエナメル質と象牙質の区別がありません"};
inline constexpr MessageText kNoDecayKnown{"no_decay_known", "the tooth has no decay", "この歯にう蝕はありません"};
inline constexpr MessageText kNoMarginLine{"no_margin_line", "the preparation has no closed margin",
                                           "窩縁または辺縁が閉じた線になっていません"};

// What the hand has done.
inline constexpr MessageText kNoSession{"no_session", "the work is not a recorded session",
                                        "記録されたセッションではありません"};
inline constexpr MessageText kNeverTouched{"never_touched", "no hand has touched the tooth in this session",
                                           "このセッションでは、手で歯に触れていません"};
inline constexpr MessageText kNoStroke{"no_stroke", "the turning bur touched nothing for longer than 0.05 s",
                                       "回転中のバーが 0.05 秒を超えて触れたことがありません"};
inline constexpr MessageText kNoLongStroke{"no_long_stroke", "no stroke took longer than 0.3 s",
                                           "0.3 秒を超えるストロークがありません"};
inline constexpr MessageText kStrokesWithoutPath{"strokes_without_path", "the bur hardly moved in its strokes",
                                                 "ストローク中にバーがほとんど動いていません"};
inline constexpr MessageText kNoExpertSession{"no_expert_session", "the ideal is not an expert's recorded session",
                                              "理想が、記録された専門家のセッションではありません"};
inline constexpr MessageText kExpertNeverTouched{"expert_never_touched",
                                                 "no hand has touched the tooth in the expert's session",
                                                 "専門家のセッションでは、手で歯に触れていません"};
inline constexpr MessageText kNoPath{"no_path", "the bur did not move", "バーが動いていません"};
inline constexpr MessageText kDentinNotReached{"dentin_not_reached", "no dentin was cut in this session",
                                               "このセッションでは象牙質を削っていません"};
inline constexpr MessageText kNoDeepDecayRemoved{"no_deep_decay_removed",
                                                 "hardly any of the deep decay was removed in this session",
                                                 "このセッションでは、深部のう蝕をほとんど除去していません"};
inline constexpr MessageText kNoPeripheryRemoved{
    "no_periphery_removed", "hardly any of the decay along the enamel was removed in this session",
    "このセッションでは、エナメル質に沿ったう蝕をほとんど除去していません"};
inline constexpr MessageText kIdealRemovesNothing{"ideal_removes_nothing", "the ideal preparation removes nothing",
                                                  "理想形成では何も削りません"};
inline constexpr MessageText kNoClutchKnown{"no_clutch_known", "recordings do not say when the bur was held",
                                            "記録には、バーを保持していた時間がありません"};
inline constexpr MessageText kNoFingerRestKnown{"no_finger_rest_known",
                                                "no device measures whether a finger rests on the teeth",
                                                "指が歯に置かれているかを計測する装置がありません"};
inline constexpr MessageText kNeverDrilled{"never_drilled", "the turning bur touched nothing",
                                           "回転中のバーは何にも触れていません"};
inline constexpr MessageText kNoMirrorKnown{"no_mirror_known", "this recording does not say how the mirror was held",
                                            "この記録にはミラーの位置がありません"};

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

inline constexpr MessageText kForbiddenCriterion{"forbidden_criterion", "Forbidden zones", "切削禁止域"};

// Marks of teachers.
inline constexpr MessageText kMarksNameEmpty{"marks_name_empty", "the column '%1' is empty here; write a name.",
                                             "列 '%1' が空です。名前を書いてください。"};
inline constexpr MessageText kMarksNameNotUtf8{
    "marks_name_not_utf8", "the column '%1' has bytes that are not UTF-8, %2; save the file as UTF-8.",
    "列 '%1' に UTF-8 でないバイトがあります（%2）。ファイルを UTF-8 で保存してください。"};
inline constexpr MessageText kMarkOutOfRange{"mark_out_of_range",
                                             "column 'mark': expected a number from 0 to 100, but found %1.",
                                             "列 'mark'：0 から 100 までの数値が必要ですが、%1 があります。"};
inline constexpr MessageText kMarkTwice{"mark_twice",
                                        "the teacher %1 has marked the work %2 before (%3); keep one of the two.",
                                        "教員 %1 は作品 %2 をすでに採点しています（%3）。どちらかを残してください。"};
inline constexpr MessageText kWorkOfTwoStudents{
    "work_of_two_students",
    "the work %1 is of the student %2 here, but of %3 before (%4); give each work a name of its own.",
    "作品 %1 は、ここでは学生 %2 のものですが、前には %3 のものです（%4）。作品ごとに別の名前を付けてください。"};
inline constexpr MessageText kTooManyMarks{"too_many_marks", "there are more than %1 marks; divide the file.",
                                           "評点が %1 件を超えています。ファイルを分けてください。"};
inline constexpr MessageText kTooManyTeachers{"too_many_teachers",
                                              "there are more than %1 teachers; leave out those with few marks.",
                                              "教員が %1 人を超えています。採点の少ない教員を除いてください。"};

// Fits to the marks of teachers.
inline constexpr MessageText kTooFewMarkedWorks{
    "too_few_marked_works",
    "a rubric is fitted to at least %1 measured and marked works of %2 students, but these are %3 of %4; add more.",
    "評価基準表を合わせるには、計測と採点の済んだ作品が、学生 %2 人以上の %1 個以上必要ですが、あるのは学生 %4 "
    "人の %3 個です。追加してください。"};
inline constexpr MessageText kMarkedWorkUnknown{
    "marked_work_unknown",
    "there is a mark of %1 for the work %2, but no such work; correct its name, or add its file.",
    "教員 %1 が採点した作品 %2 が見つかりません。名前を直すか、ファイルを加えてください。"};

// Places in a preparation.
inline constexpr MessageText kWallFloor{"wall_floor", "Floor", "窩底"};
inline constexpr MessageText kWallEnd{"wall_end", "Occlusal surface", "咬合面"};
inline constexpr MessageText kWallMesial{"wall_mesial", "Mesial wall", "近心壁"};
inline constexpr MessageText kWallDistal{"wall_distal", "Distal wall", "遠心壁"};
inline constexpr MessageText kWallBuccal{"wall_buccal", "Buccal wall", "頬側壁"};
inline constexpr MessageText kWallLingual{"wall_lingual", "Lingual wall", "舌側壁"};
inline constexpr MessageText kWallOcclusal{"wall_occlusal", "Occlusal wall", "咬合面側壁"};
inline constexpr MessageText kWallGingival{"wall_gingival", "Gingival wall", "歯肉側壁"};
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

}  // namespace tactooth::msg
