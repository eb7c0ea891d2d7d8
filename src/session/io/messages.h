// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/message.h"

/// The catalogue of this layer: what it says to people, in both languages.
namespace tactooth::msg {

// Composition.
inline constexpr MessageText kSentence{"sentence", "%1.", "%1。"};

// Text files.
inline constexpr MessageText kTomlTooLarge{"toml_too_large",
                                           "%1: the file is too large: a TOML file may have %2 bytes at most.",
                                           "%1：ファイルが大きすぎます。TOML ファイルは %2 バイトまでです。"};
inline constexpr MessageText kNotToml{"not_toml", "this is not TOML: %1", "TOML の書式ではありません：%1"};
inline constexpr MessageText kTomlNesting{"toml_nesting",
                                          "brackets stand more than %1 deep in each other; write it flatter",
                                          "括弧の入れ子が %1 段を超えています。入れ子を浅くしてください"};
inline constexpr MessageText kTomlKeyParts{"toml_key_parts",
                                           "a key has more than %1 parts with dots between them; write a shorter one",
                                           "点で区切られたキーの要素が %1 個を超えています。短いキーにしてください"};
inline constexpr MessageText kTomlValues{"toml_values", "there are more than %1 values; keep to what is asked for",
                                         "値が %1 個を超えています。必要なものだけにしてください"};
inline constexpr MessageText kTomlLine{"toml_line", "the line is longer than %1 bytes; break it up",
                                       "この行は %1 バイトを超えています。複数の行に分けてください"};
inline constexpr MessageText kUnknownKey{"unknown_key", "%1 has no key %2; the keys are %3",
                                         "%1に %2 というキーはありません。使えるキーは %3 です"};
inline constexpr MessageText kKeyMissing{"key_missing", "the key '%1' is missing", "キー '%1' がありません"};
inline constexpr MessageText kKeyEmpty{"key_empty", "the key '%1' is empty", "キー '%1' が空です"};
inline constexpr MessageText kKeyTakesText{"key_takes_text", "%1 must be a text of one line in quotes",
                                           "%1 は引用符で囲んだ1行の文字列でなければなりません"};
inline constexpr MessageText kKeyTakesTexts{"key_takes_texts", "%1 must be a list of texts",
                                            "%1 は文字列のリストでなければなりません"};
inline constexpr MessageText kKeyTakesLines{"key_takes_lines", "%1 must be a list of texts of one line in quotes",
                                            "%1 は引用符で囲んだ1行の文字列のリストでなければなりません"};
inline constexpr MessageText kKeyTakesNumber{"key_takes_number", "%1 must be a number from %2 to %3, but is %4",
                                             "%1 は %2 から %3 までの数値でなければなりません（実際の値：%4）"};
inline constexpr MessageText kKeyTakesWholeNumber{"key_takes_whole_number",
                                                  "%1 must be a whole number from %2 to %3, but is %4",
                                                  "%1 は %2 から %3 までの整数でなければなりません（実際の値：%4）"};
inline constexpr MessageText kKeyTakesFlag{"key_takes_flag", "%1 must be true or false",
                                           "%1 は true か false でなければなりません"};
inline constexpr MessageText kKeyTakesNumbers{"key_takes_numbers", "%1 must be a list of %2 numbers",
                                              "%1 は %2 個の数値のリストでなければなりません"};
inline constexpr MessageText kKeyTakesTables{"key_takes_tables", "begin each %1 with a line [[%2]]",
                                             "%1 はそれぞれ [[%2]] の行で始めてください"};
inline constexpr MessageText kKeyTakesTable{"key_takes_table", "%1 must be a list of names and values in braces",
                                            "%1 は波括弧で囲んだ名前と値の並びでなければなりません"};

// What a file holds.
inline constexpr MessageText kNotFiniteNumber{"not_finite_number", "not a finite number", "有限でない数値"};
inline constexpr MessageText kTextInQuotes{"text_in_quotes", "a text in quotes", "引用符で囲んだ文字列"};
inline constexpr MessageText kTrueOrFalse{"true_or_false", "true or false", "true か false"};
inline constexpr MessageText kAList{"a_list", "a list", "リスト"};
inline constexpr MessageText kListOf{"list_of", "a list of %1", "要素 %1 個のリスト"};
inline constexpr MessageText kATable{"a_table", "a table", "テーブル"};
inline constexpr MessageText kDateOrTime{"date_or_time", "a date or a time", "日付または時刻"};

// Materials.
inline constexpr MessageText kMaterialUnknown{"material_unknown", "there is no material %1; the materials are %2",
                                              "材料 %1 はありません。使える材料は %2 です"};
inline constexpr MessageText kMaterialNotTable{"material_not_table",
                                               "expected the keys of %1 below a line [%2], but found %3",
                                               "[%2] の行の下に %1 のキーが必要です（実際の値：%3）"};
inline constexpr MessageText kAMaterial{"a_material", "a material", "材料"};
inline constexpr MessageText kColourNotThree{
    "colour_not_three", "'colour' must be three numbers in brackets (red, green, blue), but is %1",
    "'colour' は角括弧で囲んだ三つの数値（赤、緑、青）でなければなりません（実際の値：%1）"};
inline constexpr MessageText kMaterialNameRefused{
    "material_name_refused",
    "a material cannot be named %1; take small letters, digits, - and _, at most 40, a letter first",
    "材料に %1 という名前は付けられません。小文字、数字、-、_ を 40 字以内で使い、最初は文字にしてください"};
inline constexpr MessageText kTooManyMaterials{"too_many_materials", "there are more than %1 materials; leave some out",
                                               "材料が %1 種類を超えています。いくつか除いてください"};
inline constexpr MessageText kKeyOfNewMaterial{"key_of_new_material",
                                               "%1 belongs to new materials; that of %2 is built in",
                                               "%1 は新しい材料だけに付けられます。%2 のものは組み込みです"};
inline constexpr MessageText kMaterialRole{"material_role", "'role' must be one of %1", "'role' は %1 のいずれかです"};
inline constexpr MessageText kMaterialCodeTaken{"material_code_taken",
                                                "the code %1 is that of %2; give each material its own",
                                                "コード %1 は %2 のものです。材料ごとに別のコードを付けてください"};
inline constexpr MessageText kMaterialNamed{"material_named", "there is no material '%1'; the materials are %2.",
                                            "材料 '%1' はありません。使える材料は %2 です。"};
inline constexpr MessageText kLayerNotParsed{
    "layer_not_parsed", "the layer '%1' must be given as NAME=FILE.stl, for example dentin=dentin.stl.",
    "層 '%1' は NAME=FILE.stl の形で指定してください（例：dentin=dentin.stl）。"};

// Tables.
inline constexpr MessageText kCsvNoHeader{"csv_no_header",
                                          "%1: there is no line that names the columns; begin the file with %2.",
                                          "%1：列名の行がありません。ファイルの先頭に %2 と書いてください。"};
inline constexpr MessageText kCsvNoRows{"csv_no_rows",
                                        "%1: there are no rows below the names of the columns; add at least one.",
                                        "%1：列名の下に行がありません。1 行以上追加してください。"};
inline constexpr MessageText kCsvQuotes{
    "csv_quotes", "a cell in quotes must end with its line, and nothing but a separator may follow it",
    "引用符で囲んだセルは行の中で閉じ、そのあとには区切り文字だけを続けてください"};
inline constexpr MessageText kCsvColumnMissing{
    "csv_column_missing", "the column '%1' is missing; expected the columns %2, separated by commas, but found %3",
    "列 '%1' がありません。列 %2 をコンマで区切って並べてください。見つかったのは %3 です"};
inline constexpr MessageText kCsvColumnTwice{"csv_column_twice",
                                             "the column '%1' is named twice; remove one of the two",
                                             "列 '%1' が 2 回あります。どちらかを削除してください"};
inline constexpr MessageText kCsvFields{"csv_fields", "expected %1 fields, one for each named column, but found %2",
                                        "列名と同じ %1 個の項目が必要ですが、%2 個あります"};
inline constexpr MessageText kCsvNumber{"csv_number",
                                        "column '%1': expected a finite number with '.' as decimal point, but found %2",
                                        "列 '%1': 小数点に '.' を使った有限の数値が必要ですが、%2 があります"};
inline constexpr MessageText kCsvLine{"csv_line", "%1, line %2", "%1、%2 行目"};
inline constexpr MessageText kCsvNotFinite{
    "csv_not_finite",
    "row %1 of the table has a number that is not finite, so nothing is written; check size and unit of the "
    "surfaces.",
    "表の %1 行目に有限でない数値があるため、何も書き込みませんでした。表面の大きさと単位を確かめてください。"};

// Results that are no numbers.
inline constexpr MessageText kTickNotFinite{
    "tick_not_finite",
    "at t = %1 s the %2 is not a finite number, so nothing is written; look there in the trajectory, and at the "
    "size and unit of the surfaces (see 'tactooth info').",
    "t = %1 秒で%2が有限の数値ではないため、何も書き込みませんでした。軌跡のその箇所と、"
    "表面の大きさと単位を確かめてください（'tactooth info' を参照）。"};
inline constexpr MessageText kTickForce{"tick_force", "force", "力"};
inline constexpr MessageText kTickTorque{"tick_torque", "torque", "トルク"};
inline constexpr MessageText kTickDepth{"tick_depth", "depth", "深さ"};
inline constexpr MessageText kTickNormal{"tick_normal", "normal", "法線"};
inline constexpr MessageText kTickProxy{"tick_proxy", "proxy", "プロキシ"};
inline constexpr MessageText kTickHand{"tick_hand", "hand", "手の位置"};
inline constexpr MessageText kTickSpeed{"tick_speed", "speed", "速度"};
inline constexpr MessageText kTickBurSpeed{"tick_bur_speed", "speed of the bur", "バーの回転数"};
inline constexpr MessageText kTickBurWork{"tick_bur_work", "work of the bur", "バーの仕事"};
inline constexpr MessageText kTickContactPoint{"tick_contact_point", "point of contact", "接触点"};

// Voxel files.
inline constexpr MessageText kVdbNotWritten{"vdb_not_written", "%1: cannot be written: OpenVDB says: %2.",
                                            "%1：書き込めません。OpenVDB の報告：%2。"};
inline constexpr MessageText kNoOpenVdb{
    "no_open_vdb",
    "this program was built without OpenVDB and cannot write .vdb files: install OpenVDB (Debian: "
    "libopenvdb-dev) and build it again.",
    "このプログラムは OpenVDB なしでビルドされたため、.vdb ファイルを書けません。OpenVDB（Debian では "
    "libopenvdb-dev）をインストールして、ビルドし直してください。"};
inline constexpr MessageText kVdbTooLarge{
    "vdb_too_large",
    "the voxel file would hold about %1 GB at %2 mm a voxel; give a coarser --voxel (is the surface in "
    "micrometres?).",
    "ボクセルファイルは 1 ボクセル %2 mm で約 %1 GB になります。--voxel "
    "をもっと粗くしてください（表面の単位がマイクロメートルではありませんか）。"};

// Trajectories.
inline constexpr MessageText kQuaternionLength{
    "quaternion_length",
    "%1: the quaternion qw,qx,qy,qz must have length 1, but its length is %2; write 1,0,0,0 for a tool that is "
    "not turned.",
    "%1：クォータニオン qw,qx,qy,qz の長さは 1 でなければなりませんが、%2 です。回転していない場合は 1,0,0,0 "
    "と書いてください。"};
inline constexpr MessageText kToolTooFar{
    "tool_too_far", "%1: the tool is farther than 10 m from the tooth's origin; x,y,z are in mm, so check the unit.",
    "%1：器具が歯の原点から 10 m より遠くにあります。x,y,z の単位は mm です。単位を確かめてください。"};
inline constexpr MessageText kTimeTooLarge{
    "time_too_large", "%1: t is too large; t is in s, so check the unit.",
    "%1：t が時計の秒として大きすぎます。t の単位は秒です。単位を確かめてください。"};
inline constexpr MessageText kTimeBackwards{
    "time_backwards", "%1: time runs backwards (t is less than in the row above); sort the rows by t.",
    "%1：時刻が逆戻りしています（t が上の行より小さい）。行を t の順に並べ替えてください。"};

// Teeth.
inline constexpr MessageText kSavedToothHasLayers{"saved_tooth_has_layers",
                                                  "%1: a saved tooth has its own layers; give no others.",
                                                  "%1：保存した歯には層が含まれています。他の層は加えないでください。"};
inline constexpr MessageText kSavedToothHasSpacing{
    "saved_tooth_has_spacing", "%1: a saved tooth keeps the spacing that it was cut with, %2 um; give no other.",
    "%1：保存した歯は、削ったときの格子間隔 %2 µm のままです。別の間隔は指定しないでください。"};
inline constexpr MessageText kCaseHasLayers{"case_has_layers", "%1: a case has its own layers; give no others.",
                                            "%1：症例には層が含まれています。他の層は加えないでください。"};
inline constexpr MessageText kNoChoiceOfTooth{"no_choice_of_tooth",
                                              "%1: this is one tooth; a tooth can be chosen in a case only.",
                                              "%1：これは1本の歯です。歯を選べるのは症例だけです。"};

inline constexpr MessageText kNoteUnknownMaterial{
    "note_unknown_material",
    "The material '%1' of this tooth is not known here: it is touched, cut, drawn and heard as bone. Give the file of "
    "its materials (--materials).",
    "この歯の材料「%1」はここでは未知です。触感、切削、表示、音は骨として扱います。"
    "材料のファイルを指定してください（--materials）。"};

// Sounds.
inline constexpr MessageText kSoundPartUnknown{"sound_part_unknown", "there is no part %1; the parts are %2",
                                               "%1 という部分はありません。使えるのは %2 です"};
inline constexpr MessageText kSoundParts{"sound_parts", "motor, cutting, water and suction",
                                         "motor、cutting、water、suction"};
inline constexpr MessageText kSoundKeys{"sound_keys", "file, speed_rpm and gain_db", "file、speed_rpm、gain_db"};
inline constexpr MessageText kCuttingNeedsMaterial{
    "cutting_needs_material", "'cutting' needs a material: write [cutting.enamel]",
    "'cutting' には材料が必要です。[cutting.enamel] のように書いてください"};
inline constexpr MessageText kSoundPartNotTable{"sound_part_not_table", "%1 must be a table with the keys %2",
                                                "%1 は %2 のキーを持つテーブルでなければなりません"};
inline constexpr MessageText kSoundPartNoRecording{"sound_part_no_recording",
                                                   "%1 has no recording; add file = \"NAME.wav\"",
                                                   "%1 に録音がありません。file = \"NAME.wav\" を加えてください"};
inline constexpr MessageText kSoundPartNoSpeed{
    "sound_part_no_speed",
    "%1 needs the speed of the bur when it was recorded, whose pitch it follows; add speed_rpm = 400000 or what "
    "it was",
    "%1 には録音したときのバーの回転数が必要です（音の高さがこれに従います）。speed_rpm = 400000 "
    "のように加えてください"};
inline constexpr MessageText kSoundFileNotText{"sound_file_not_text", "'file' must be a name in quotes",
                                               "'file' は引用符で囲んだ名前でなければなりません"};
inline constexpr MessageText kARecording{"a_recording", "a recording", "録音"};
inline constexpr MessageText kMustLieBeside{
    "must_lie_beside", "%1 must lie beside this file or below it, named with '/' and without '..'",
    "%1 はこのファイルと同じフォルダーかその下に置き、'/' を使い、'..' を使わずに書いてください"};
inline constexpr MessageText kSoundLinkLeadsOut{
    "sound_link_leads_out", "%1 is a link that leads out of the folder of this file; put a copy there instead.",
    "%1 はこのファイルのフォルダーの外を指すリンクです。代わりに複製を置いてください。"};

// Profiles of sound.
inline constexpr MessageText kProfileBackwards{
    "profile_backwards", "time runs backwards (t is less than in the row above); sort the rows by t.",
    "時刻が逆戻りしています（t が上の行より小さい）。行を t の順に並べ替えてください。"};
inline constexpr MessageText kProfileSpeed{"profile_speed", "speed_rpm must be from 0 to 1000000 rev/min, but is %1.",
                                           "speed_rpm は 0 から 1000000 回転/分まででなければなりませんが、%1 です。"};
inline constexpr MessageText kProfilePower{"profile_power", "power must be from 0 to 1000 W, but is %1.",
                                           "power は 0 から 1000 W まででなければなりませんが、%1 です。"};
inline constexpr MessageText kProfileMaterial{"profile_material",
                                              "there is no material %1; the materials are %2, and none.",
                                              "材料 %1 はありません。使えるのは %2、none です。"};
inline constexpr MessageText kProfileNoTime{
    "profile_no_time", "%1: the rows span no time, so there is nothing to hear; add a row with a later t.",
    "%1：行の間に時間がなく、聞こえる音がありません。もっと後の t の行を加えてください。"};
inline constexpr MessageText kProfileTooLong{
    "profile_too_long", "%1: this is more than an hour after the first row; cut the profile into shorter ones.",
    "%1：最初の行から 1 時間を超えています。プロファイルを短く分けてください。"};

// Events of a cut.
inline constexpr MessageText kFirstContact{"first_contact", "first contact", "最初の接触"};
inline constexpr MessageText kDentinReached{"dentin_reached", "dentin reached", "象牙質に到達"};
inline constexpr MessageText kPulpNear{"pulp_near", "pulp near", "歯髄に近接"};
inline constexpr MessageText kPulpExposed{"pulp_exposed", "pulp exposed", "歯髄が露出"};
inline constexpr MessageText kNeighbourTouched{"neighbour_touched", "neighbour touched", "隣在歯に接触"};
inline constexpr MessageText kGingivaTouched{"gingiva_touched", "gum or bone touched", "歯肉または骨に接触"};
inline constexpr MessageText kAdjacentCut{"adjacent_cut", "cut beside the tooth", "対象の歯以外を切削"};
inline constexpr MessageText kBurStalled{"bur_stalled", "bur stalled", "バーが停止"};
inline constexpr MessageText kFragmentReleased{"fragment_released", "piece came loose", "歯片が脱落"};

}  // namespace tactooth::msg
