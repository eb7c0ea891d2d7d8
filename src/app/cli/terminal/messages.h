// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/util/message.h"

/// The catalogue of this layer: what it says to people, in both languages.
namespace tactooth::msg {

// Teeth.
inline constexpr MessageText kNoPermanentToothGiven{
    "no_permanent_tooth_given", "%1 is no permanent tooth; FDI numbers are 11-18, 21-28, 31-38 and 41-48.",
    "%1 は永久歯ではありません。FDI の番号は 11～18、21～28、31～38、41～48 です。"};
inline constexpr MessageText kMissingNotPermanent{
    "missing_not_permanent", "%1 in --missing is no permanent tooth; FDI numbers are 11-18, 21-28, 31-38 and 41-48.",
    "--missing の %1 は永久歯ではありません。FDI の番号は 11～18、21～28、31～38、41～48 です。"};
inline constexpr MessageText kMouthNeedsTooth{
    "mouth_needs_tooth", "what follows --mouth must be the number of a permanent tooth: 11-18, 21-28, 31-38 or 41-48.",
    "--mouth の後には永久歯の番号（11～18、21～28、31～38、41～48）を書いてください。"};
inline constexpr MessageText kNoOcclusalSurface{
    "no_occlusal_surface",
    "%1 is an anterior tooth and has no occlusal surface; choose mesial, distal, buccal or lingual for --caries.",
    "%1 は前歯で、咬合面がありません。--caries には mesial、distal、buccal、lingual のいずれかを選んでください。"};
inline constexpr MessageText kTooManyTeeth{
    "too_many_teeth", "--teeth names %1 teeth, and a sheet has room for %2; name each once.",
    "--teeth に %1 本の歯がありますが、1 枚に入るのは %2 本です。それぞれ一度だけ書いてください。"};
inline constexpr MessageText kToothNotCut{"tooth_not_cut", "the tooth cannot be cut: %1.", "この歯は削れません：%1。"};
inline constexpr MessageText kToothNotClosed{
    "tooth_not_closed", "%1 is not closed, so its triangles cannot be made fewer; measure it with --resolution 100.",
    "%1 は閉じていないため、三角形を減らせません。--resolution 100 で測ってください。"};
inline constexpr MessageText kNoSavedToothGiven{
    "no_saved_tooth_given",
    "%1 is no saved tooth: give one that 'tactooth cut --save' or the window (Ctrl+S) has written, which knows "
    "what was cut from it.",
    "%1 は保存された歯ではありません。'tactooth cut --save' かウィンドウ（Ctrl+S）で保存した、"
    "削った跡の分かる歯を指定してください。"};

// Cases and exercises.
inline constexpr MessageText kUnitUnknown{
    "unit_unknown",
    "--units %1 is no unit; give mm, cm, inch, m, um, or how many mm one unit is, from 0.000001 to 1000000.",
    "--units の %1 は単位ではありません。mm、cm、inch、m、um のいずれか、または 1 単位が何 mm かを 0.000001 から "
    "1000000 までの数値で指定してください。"};
inline constexpr MessageText kArchiveNeedsUtf8{
    "archive_needs_utf8", "%1: an archive takes names in UTF-8 only; give the file another name.",
    "%1：アーカイブに入れられるのは UTF-8 の名前だけです。ファイルの名前を変えてください。"};
inline constexpr MessageText kCaseNameEnding{"case_name_ending", "%1: a packed case is a file whose name ends in %2.",
                                             "%1：まとめた症例のファイル名は %2 で終わります。"};
inline constexpr MessageText kIdealLeavesNothing{
    "ideal_leaves_nothing",
    "%1: the ideal shape leaves nothing to cut; it must lie in the frame of the tooth, and have its cavity "
    "inside it.",
    "%1：理想形状には削るところがありません。歯と同じ座標系で、窩洞を含む形にしてください。"};
inline constexpr MessageText kToleranceBeyondRange{
    "tolerance_beyond_range",
    "--tolerance %1 must be smaller than --range (%2): beyond the range all colours are equal.",
    "--tolerance %1 は --range（%2）より小さくしてください。範囲の外では色が変わりません。"};
inline constexpr MessageText kTargetLeavesNoGhost{
    "target_leaves_no_ghost",
    "%1 leaves nothing to cut: no part of it lies inside the uncut tooth, so there is no ghost; choose the "
    "surface of the same tooth with its cavity, in the same frame.",
    "%1 には削るところがありません。削る前の歯の内側にある部分がなく、目標を表示できません。同じ座標系で、"
    "窩洞のある同じ歯の表面を選んでください。"};

// Burs.
inline constexpr MessageText kNoBurGiven{"no_bur_given", "there is no bur: give --bur, or a case that brings one.",
                                         "バーがありません。--bur か、バーの入った症例を指定してください。"};
inline constexpr MessageText kNoBurNamed{"no_bur_named", "no bur is named; give a number, or --list for all of them.",
                                         "バーが指定されていません。番号か、一覧を出す --list を指定してください。"};
inline constexpr MessageText kBurNotListed{
    "bur_not_listed", "the catalogue has no bur '%1'; 'tactooth bur --list' shows what it has.",
    "バー '%1' はカタログにありません。一覧は 'tactooth bur --list' で分かります。"};
inline constexpr MessageText kOutMissing{"out_missing", "--out is missing; name the STL file to write.",
                                         "--out がありません。書き込む STL ファイルを指定してください。"};

// Meshes.
inline constexpr MessageText kKeepUnknown{
    "keep_unknown", "--keep %1 is neither a share, for example 50%, nor a number of triangles, for example 20000.",
    "--keep の %1 は、割合（例：50%）でも三角形の数（例：20000）でもありません。"};
inline constexpr MessageText kSimplifiedCrossing{
    "simplified_crossing", "%1: with %2 triangles the surface would cross itself by %3 mm; keep more of them.",
    "%1：三角形が %2 個では表面が %3 mm 自己交差します。もっと多く残してください。"};
inline constexpr MessageText kTooManyTriangles{
    "too_many_triangles", "%1: %2 triangles would be made, and %3 are the most; ask for fewer.",
    "%1：三角形が %2 個になりますが、上限は %3 個です。少なくしてください。"};

// Pictures.
inline constexpr MessageText kPictureSizeUnknown{
    "picture_size_unknown", "%1 is not a size: write WIDTHxHEIGHT in pixels, each 16 to 16384, as 1920x1080.",
    "%1 は大きさではありません。WIDTHxHEIGHT の形で、それぞれ 16～16384 ピクセルで書いてください（例："
    "1920x1080）。"};
inline constexpr MessageText kPictureTooLarge{
    "picture_too_large",
    "a picture of %1 pixels is too large: 16.8 million pixels in all, as 4096x4096 or 5120x3200, are the most.",
    "%1 ピクセルの画像は大きすぎます。全部で 1680 万ピクセル（4096x4096、5120x3200 など）までです。"};
inline constexpr MessageText kViewUnknown{
    "view_unknown",
    "%1 is not a view: choose occlusal, buccal, lingual, mesial, distal, dentist or AZIMUTH,ELEVATION in "
    "degrees.",
    "%1 という視点はありません。occlusal、buccal、lingual、mesial、distal、dentist、または度で表した "
    "AZIMUTH,ELEVATION を選んでください。"};
inline constexpr MessageText kPointUnknown{
    "point_unknown", "%1 is not a point: write X,Y,Z in mm, each from -1000 to 1000, as 1.5,-2,7.",
    "%1 は点ではありません。X,Y,Z の形で、それぞれ -1000 から 1000 mm で書いてください（例：1.5,-2,7）。"};
inline constexpr MessageText kClipPlaneUnknown{
    "clip_plane_unknown",
    "%1 is not a clip plane: choose occlusal, buccal, lingual, mesial or distal, and if need be how far from "
    "the tooth's middle, as buccal=1.5 (mm).",
    "%1 は断面ではありません。occlusal、buccal、lingual、mesial、distal のいずれかを選び、"
    "必要なら歯の中央からの距離を書いてください（例：buccal=1.5、単位 mm）。"};
inline constexpr MessageText kNothingTransparent{
    "nothing_transparent", "%1 makes nothing transparent: write a material and its opacity from 0 to 1, as enamel=0.3.",
    "%1 では何も透明になりません。材料と不透明度（0～1）を書いてください（例：enamel=0.3）。"};
inline constexpr MessageText kMouthViewUnknown{
    "mouth_view_unknown",
    "there is no view '%1' of the mouth; choose front, right, left, upper, lower, dentist, or AZIMUTH,ELEVATION "
    "in degrees.",
    "口の視点 '%1' はありません。front、right、left、upper、lower、dentist、または度で表した AZIMUTH,ELEVATION "
    "を選んでください。"};
inline constexpr MessageText kSoftTissuesOfOpenMouth{
    "soft_tissues_of_open_mouth", "--soft-tissues shows what surrounds an open mouth; add --jaw open.",
    "--soft-tissues は開いた口のまわりを表示します。--jaw open も書いてください。"};

// The command line.
inline constexpr MessageText kRecordingBringsAll{
    "recording_brings_all", "a recorded session brings its own tooth; leave out --work-on, --layer and --materials.",
    "セッションの記録には歯が含まれています。--work-on、--layer、--materials を付けずに実行してください。"};
inline constexpr MessageText kCommandUnknown{
    "command_unknown", "there is no command and no case '%1'; see 'tactooth --help'.",
    "'%1' というコマンドも症例もありません。'tactooth --help' を参照してください。"};
inline constexpr MessageText kMemoryTooSmall{
    "memory_too_small",
    "the memory does not suffice for this; ask for less (coarser voxels, fewer triangles, a smaller picture), or "
    "close other programs.",
    "メモリーが足りません。要求を減らすか（粗いボクセル、少ない三角形、小さい画像）、"
    "他のプログラムを閉じてください。"};
inline constexpr MessageText kSurfaceTooLarge{
    "surface_too_large", "%1: %2 x %3 x %4 mm do not fit into memory; is it in micrometres?",
    "%1：%2 x %3 x %4 mm はメモリーに収まりません。単位がマイクロメートルではありませんか？"};

// Facts about surfaces.
inline constexpr MessageText kWhenUsed{"when_used", "When used", "使用時"};
inline constexpr MessageText kTheSurfaceItself{"the_surface_itself", "The surface", "表面"};

}  // namespace tactooth::msg
