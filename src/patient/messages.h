// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/message.h"

/// The catalogue of this layer: what it says to people, in both languages.
namespace tactooth::msg {

// Importing a scan.
inline constexpr MessageText kStopped{"stopped", "stopped", "中止しました"};
inline constexpr MessageText kNoSurface{"no_surface", "%1: there is no surface.", "%1：表面がありません。"};
inline constexpr MessageText kLayersNotClosed{
    "layers_not_closed", "the layers give no closed surface together; give the tooth's outer surface as a file, too",
    "層を合わせても閉じた表面になりません。歯の外表面のファイルも加えてください"};
inline constexpr MessageText kTheSurfaceNamed{"the_surface_named", "the surface '%1'", "表面 '%1'"};
inline constexpr MessageText kHolesTooWide{
    "holes_too_wide",
    "%1: the surface '%2' has %3 holes that are too wide to be filled unasked (%4 open edges); ask for all holes "
    "to be filled, or close it in a mesh program.",
    "%1：表面 '%2' に、自動でふさぐには大きすぎる穴が %3 個あります（開いた辺 %4 本）。"
    "「すべての穴をふさぐ」を選ぶか、メッシュ編集ソフトで閉じてください。"};
inline constexpr MessageText kHolesNotClosed{
    "holes_not_closed",
    "%1: the surface '%2' cannot be closed (%3 open edges): walls meet inside it, or pieces hang together with "
    "nothing; close it in a mesh program.",
    "%1：表面 '%2' を閉じられません（開いた辺 %3 本）。内部で壁が交わっているか、"
    "どこにもつながらない断片があります。メッシュ編集ソフトで閉じてください。"};
inline constexpr MessageText kFilledCrossing{
    "filled_crossing",
    "%1: the surface '%2' crosses itself by %3 mm once its %4 holes are filled; close it in a mesh program.",
    "%1：表面 '%2' は %4 個の穴をふさぐと %3 mm 自己交差します。メッシュ編集ソフトで閉じてください。"};

// Names in import notes.
inline constexpr MessageText kOuterSurface{"outer_surface", "outer", "外表面"};

// Import notes: units.
inline constexpr MessageText kNoteUnitOfTooth{
    "note_unit_of_tooth", "Units taken as %1, because the longest side would be %2 mm, as that of a whole tooth.",
    "単位は %1 とみなしました。最も長い辺が %2 mm となり、歯全体の大きさに合うためです。"};
inline constexpr MessageText kNoteUnitOfCrown{
    "note_unit_of_crown", "Units taken as %1, because the longest side would be %2 mm, as that of a crown.",
    "単位は %1 とみなしました。最も長い辺が %2 mm となり、歯冠の大きさに合うためです。"};
inline constexpr MessageText kNoteNoUnit{
    "note_no_unit",
    "No unit of length makes this a tooth (longest side %1): scaled by %2 to the %3 mm of an average tooth.",
    "どの長さの単位でも歯の大きさになりません（最も長い辺 %1）。%2 倍して平均的な歯の長さ %3 mm にしました。"};
inline constexpr MessageText kNoteScaled{"note_scaled", "Scaled by %1, as chosen: the longest side is %2 mm.",
                                         "指定により %1 倍しました。最も長い辺は %2 mm です。"};

// Import notes: layers.
inline constexpr MessageText kNoteOneLayer{"note_one_layer", "There is one layer: its surface is the tooth's.",
                                           "層は一つだけです。その表面を歯の表面とします。"};
inline constexpr MessageText kNoteLayersWelded{
    "note_layers_welded",
    "The outer surface was welded from the layers: vertices within %1 mm became one, and faces in common fell "
    "away.",
    "外表面は層をつなぎ合わせて作りました。%1 mm 以内の頂点は一つにし、共有する面は取り除きました。"};
inline constexpr MessageText kNoteLayersMerged{
    "note_layers_merged",
    "The layers do not fit within %1 mm: the outer surface was made anew around all of them, with triangles of "
    "%2 mm.",
    "層は %1 mm 以内では合いません。全体を囲む外表面を %2 mm の三角形で作り直しました。"};
inline constexpr MessageText kNoteAllEnamel{"note_all_enamel", "The whole tooth is taken as enamel, as chosen.",
                                            "指定により歯全体をエナメル質とします。"};
inline constexpr MessageText kNoteNoEnamel{
    "note_no_enamel", "No enamel is given: what no other layer holds is taken as enamel.",
    "エナメル質が与えられていません。どの層にも含まれない部分をエナメル質とします。"};
inline constexpr MessageText kNoteModelled{
    "note_modelled",
    "Only the outer surface is known: enamel and dentin are a model, with enamel up to %1 mm thick that thins to "
    "nothing at the neck. They are no measurement of this tooth.",
    "外表面だけが分かっています。エナメル質と象牙質はモデルで、エナメル質は最大 %1 mm、"
    "歯頸部に向かって薄くなります。この歯の実測ではありません。"};
inline constexpr MessageText kNotePulpModelled{
    "note_pulp_modelled", "The pulp is a model, too: a chamber at the neck and a canal down each root.",
    "歯髄もモデルです。歯頸部の髄室と各歯根の根管からなります。"};
inline constexpr MessageText kNoteNoPulp{"note_no_pulp", "There is no room for a pulp: the tooth has none.",
                                         "歯髄の入る余地がないため、この歯に歯髄はありません。"};
inline constexpr MessageText kNotePulpVoid{
    "note_pulp_void", "The surface encloses a void: it is taken as the pulp space, which is empty.",
    "表面は空洞を囲んでいます。これを歯髄腔とみなし、空とします。"};

// Import notes: orientation.
inline constexpr MessageText kNoteNoLongAxis{
    "note_no_long_axis", "The surface is about as long as wide: +z of the file is taken as the crown's side.",
    "長さと幅がほぼ同じです。ファイルの +z を歯冠の側とみなしました。"};
inline constexpr MessageText kNoteCrownAtEnamel{"note_crown_at_enamel", "The crown is where the enamel is.",
                                                "エナメル質のある側を歯冠としました。"};
inline constexpr MessageText kNoteCrownThicker{"note_crown_thicker",
                                               "The thicker end of the long axis is taken as the crown.",
                                               "長軸の太い側を歯冠とみなしました。"};
inline constexpr MessageText kNoteCheekOutward{
    "note_cheek_outward", "The cheek's side is the one that looks away from the middle of the arch.",
    "歯列弓の中央から外を向く側を頬側としました。"};
inline constexpr MessageText kNoteUpright{
    "note_upright", "It stands crown up as it came (%1 degrees from +z): its axes are kept, with the cheek at +y.",
    "もとのまま歯冠が上を向いています（+z から %1 度）。軸はそのままとし、+y を頬側とします。"};
inline constexpr MessageText kNoteTurnedUpright{
    "note_turned_upright",
    "Turned by %1 degrees to stand crown up; the cheek's side cannot be seen from one surface and is taken to be "
    "+y of the file.",
    "歯冠が上を向くように %1 度回しました。頬側は一つの表面からは分からないため、ファイルの +y とみなしました。"};
inline constexpr MessageText kNoteTilted{
    "note_tilted",
    "The thicker end of the long axis points %1 degrees away from +z, where the crown should be: File > Import scan, "
    "or 'tactooth case new', turns such a tooth upright.",
    "長軸の太い端が、歯冠のあるべき +z から %1 度ずれています。「ファイル」＞「スキャンの取り込み」か 'tactooth case "
    "new' "
    "で取り込むと、歯が立ちます。"};
inline constexpr MessageText kNoteUpsideDown{"note_upside_down", "Turned upside down, as chosen.",
                                             "指定により上下を逆にしました。"};
inline constexpr MessageText kNoteTurnedAbout{"note_turned_about",
                                              "Turned by %1 degrees about the long axis, as chosen.",
                                              "指定により長軸のまわりに %1 度回しました。"};

// Import notes: repair.
inline constexpr MessageText kNoteDegenerate{"note_degenerate", "%1: %2 empty or doubled triangles were dropped.",
                                             "%1：面積のない、または重複した三角形 %2 個を取り除きました。"};
inline constexpr MessageText kNoteTurnedOutward{"note_turned_outward", "%1: %2 triangles were turned to face outward.",
                                                "%1：三角形 %2 個を外向きに直しました。"};
inline constexpr MessageText kNoteHolesFilled{"note_holes_filled",
                                              "%1: %2 holes were filled, the largest with a rim of %3 mm.",
                                              "%1：穴 %2 個をふさぎました。最大の穴の縁は %3 mm です。"};
inline constexpr MessageText kNoteSound{"note_sound", "%1: closed and sound as it came, %2 triangles.",
                                        "%1：もとから閉じていて問題ありません（三角形 %2 個）。"};
inline constexpr MessageText kNoteShells{"note_shells", "%1: consists of %2 separate shells.",
                                         "%1：%2 個の独立した殻からなります。"};

}  // namespace tactooth::msg
