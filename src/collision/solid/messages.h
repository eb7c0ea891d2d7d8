// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/message.h"

/// The catalogue of this layer: what it says to people, in both languages.
namespace tactooth::msg {

// Why a surface is no solid.
inline constexpr MessageText kSolidEmpty{"solid_empty",
                                         "%1 holds no room: give a closed surface with triangles that have an area",
                                         "%1は体積がありません。面積のある三角形からなる閉じた表面を指定してください"};
inline constexpr MessageText kSolidOpen{
    "solid_open", "%1 is open (%2 edges without a neighbour), so it has no inside: close its holes first",
    "%1が閉じておらず（隣のない辺 %2 本）、内部がありません。先に穴をふさいでください"};
inline constexpr MessageText kSolidTwisted{"solid_twisted",
                                           "%1 is twisted: it has no outside; repair it in a mesh program",
                                           "%1はねじれていて外側がありません。メッシュ編集ソフトで修復してください"};
inline constexpr MessageText kSolidOverlapping{
    "solid_overlapping",
    "%1 has parts that reach into each other by %2 mm (%3 triangles cross), so what is inside is unclear: unite "
    "them in a mesh program",
    "%1に互いに %2 mm 入り込んだ部分があり（交差する三角形 %3 個）、どこが内部か決まりません。"
    "メッシュ編集ソフトで一つに統合してください"};
inline constexpr MessageText kSolidCrossing{
    "solid_crossing", "%1 bounds no body: its triangles cross each other nearly everywhere; export it again",
    "%1は立体を囲んでいません。三角形がほぼ全体で互いに交差しています。書き出し直してください"};

// Import notes.
inline constexpr MessageText kNoteWelded{"note_welded",
                                         "%1: %2 corners that differ in their last digits were welded, within %3 mm.",
                                         "%1：末尾の桁だけが異なる頂点 %2 個をつなぎました（%3 mm 以内）。"};
inline constexpr MessageText kNoteDuplicates{
    "note_duplicates", "%1: %2 triangles that are stored twice, or lie back to back, were dropped.",
    "%1：重複した、または背中合わせの三角形 %2 個を取り除きました。"};
inline constexpr MessageText kNoteSpecks{"note_specks", "%1: %2 specks beside the surface were dropped.",
                                         "%1：表面から離れた微小な断片 %2 個を取り除きました。"};
inline constexpr MessageText kNoteTurned{"note_turned", "%1: %2 triangles were turned, so that all face outward.",
                                         "%1：すべてが外側を向くように三角形 %2 個の向きを直しました。"};
inline constexpr MessageText kNoteVoids{"note_voids",
                                        "%1: %2 shells lie within another one and are taken as the walls of voids.",
                                        "%1：別の殻の内側にある殻 %2 個は空洞の壁とみなします。"};
inline constexpr MessageText kNoteCrossings{
    "note_crossings", "%1: %2 triangles cross others by %3 mm at most; they are left as they are.",
    "%1：三角形 %2 個が他と最大 %3 mm 交差していますが、そのままにします。"};

}  // namespace tactooth::msg
