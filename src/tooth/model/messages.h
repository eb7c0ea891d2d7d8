// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/message.h"

/// The catalogue of this layer: what it says to people, in both languages.
namespace tactooth::msg {

// Layers of a tooth.
inline constexpr MessageText kTheTooth{"the_tooth", "the tooth", "歯"};
inline constexpr MessageText kLayerNamed{"layer_named", "layer '%1'", "層「%1」"};
inline constexpr MessageText kSurfaceOfNothing{"surface_of_nothing",
                                               "the surface of %1 holds no triangle: give a closed STL surface",
                                               "%1の表面に三角形がありません。閉じた STL の表面を使ってください"};
inline constexpr MessageText kSurfaceOpen{
    "surface_open",
    "the surface of %1 is open (%2 edges without a neighbour), so it has no inside to cut: close its holes first",
    "%1の表面が閉じておらず（隣のない辺 %2 本）、削る内部がありません。先に穴をふさいでください"};
inline constexpr MessageText kSurfaceInsideOut{
    "surface_inside_out",
    "the surface of %1 is inside out (its normals point inward): reverse the order of its triangles' corners",
    "%1の表面が裏返しです（法線が内側を向いています）。三角形の頂点の順序を逆にしてください"};
inline constexpr MessageText kLayerGivenTwice{"layer_given_twice",
                                              "%1 is given twice: give each layer of a tooth its own name",
                                              "%1が二つあります。歯の層にはそれぞれ別の名前を付けてください"};
inline constexpr MessageText kLayerOutside{
    "layer_outside", "%1 lies outside the tooth: give all layers in the frame of the outer surface",
    "%1が歯の外側にあります。すべての層を外表面と同じ座標系にしてください"};

// Cutting tools.
inline constexpr MessageText kToolWithoutExtent{
    "tool_without_extent",
    "the tool's surface has no extent along its axis (z of the tool frame): give the bur's closed STL with its "
    "tip at the origin and its shaft along +z",
    "バーの表面に軸方向（工具の座標系の z）の長さがありません。先端を原点、軸を +z に合わせた、閉じた STL "
    "を使ってください"};

// Saved teeth.
inline constexpr MessageText kSavedToothRefused{"saved_tooth_refused", "%1, byte %2: %3", "%1、%2 バイト目：%3"};
inline constexpr MessageText kSavedToothCutShort{
    "saved_tooth_cut_short", "the file is cut short; save the tooth again or use a complete copy.",
    "ファイルが途中で切れています。歯を保存し直すか、完全なコピーを使ってください。"};
inline constexpr MessageText kNoSavedTooth{"no_saved_tooth",
                                           "this is no saved tooth; choose a file that Tactooth has saved.",
                                           "保存された歯ではありません。Tactooth で保存したファイルを選んでください。"};
inline constexpr MessageText kSavedToothVersion{
    "saved_tooth_version",
    "the file has format version %1, and this program reads versions 1 to %2; open it with the program that "
    "saved it.",
    "ファイルの形式はバージョン %1 ですが、このプログラムが読めるのはバージョン 1 から %2 です。"
    "保存したプログラムで開いてください。"};
inline constexpr MessageText kSavedToothMaterials{
    "saved_tooth_materials",
    "the tooth has more materials than this program can hold beside its own (%1); take materials out of the file "
    "of --materials.",
    "この歯の材料は、このプログラムの材料と合わせて上限（%1）を超えています。--materials "
    "のファイルから材料を減らしてください。"};
inline constexpr MessageText kSavedToothTooLong{
    "saved_tooth_too_long", "there is more in the file than the tooth; use an undamaged copy.",
    "ファイルに歯以外のデータが入っています。壊れていないコピーを使ってください。"};
inline constexpr MessageText kSavedToothDamaged{"saved_tooth_damaged", "the file is damaged; use another copy of it.",
                                                "ファイルが壊れています。別のコピーを使ってください。"};

}  // namespace tactooth::msg
