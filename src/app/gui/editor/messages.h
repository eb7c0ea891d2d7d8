// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/util/message.h"

/// The catalogue of this layer: what it says to people, in both languages.
namespace tactooth::msg {

// What an exercise still needs.
inline constexpr MessageText kDraftName{"draft_name", "Give the exercise a name.", "課題に名前を付けてください。"};
inline constexpr MessageText kDraftTask{"draft_task", "Say in a sentence what the student is to do.",
                                        "学生が何をするのかを、一文で書いてください。"};
inline constexpr MessageText kDraftNoOutline{"draft_no_outline",
                                             "Draw the outline: click its points on the tooth, or take a template.",
                                             "外形を描いてください。歯の上で点をクリックするか、ひな形を選びます。"};
inline constexpr MessageText kDraftOpenOutline{"draft_open_outline", "Click the first point to close the line.",
                                               "最初の点をクリックして線を閉じてください。"};
inline constexpr MessageText kDraftOutlineCrosses{"draft_outline_crosses", "The outline crosses itself.",
                                                  "外形が自分自身と交わっています。"};
inline constexpr MessageText kDraftOutlineNarrow{"draft_outline_narrow",
                                                 "The outline is too narrow: the bur, %1 mm wide, has no room in it.",
                                                 "外形が狭すぎます。直径 %1 mm のバーが入りません。"};
inline constexpr MessageText kDraftFloorNarrow{
    "draft_floor_narrow", "The walls lean so much that the bur, %1 mm wide, has no room on the floor.",
    "側壁の傾きが大きく、窩底に直径 %1 mm のバーが入りません。"};
inline constexpr MessageText kDraftZoneSmall{"draft_zone_small",
                                             "A forbidden zone needs three points; click more, or remove it.",
                                             "切削禁止域には点が三つ要ります。点を加えるか、切削禁止域を削除して"
                                             "ください。"};
inline constexpr MessageText kDraftZoneCrosses{"draft_zone_crosses", "The line of a forbidden zone crosses itself.",
                                               "切削禁止域の線が自分自身と交わっています。"};
inline constexpr MessageText kDraftMesialBox{"draft_mesial_box",
                                             "The outline does not reach the axial wall of the mesial box.",
                                             "外形が近心の隣接面窩洞の軸側壁に届いていません。"};
inline constexpr MessageText kDraftDistalBox{"draft_distal_box",
                                             "The outline does not reach the axial wall of the distal box.",
                                             "外形が遠心の隣接面窩洞の軸側壁に届いていません。"};
inline constexpr MessageText kDraftBoxNarrow{"draft_box_narrow",
                                             "A box is at least as wide and as deep as the bur, %1 mm.",
                                             "隣接面窩洞の幅と深さは、バーの直径 %1 mm 以上にしてください。"};

// Why there is no ideal cavity.
inline constexpr MessageText kDraftNoIdeal{"draft_no_ideal", "The ideal cavity cannot be made: %1",
                                           "理想窩洞を作れません。%1"};
inline constexpr MessageText kDraftIdealEmpty{
    "draft_ideal_empty", "The ideal cavity takes nothing away from the tooth.", "理想窩洞が歯を少しも削っていません。"};

// What templates call an exercise.
inline constexpr MessageText kDraftTitle{"draft_title", "%1, %2", "%1 %2"};
inline constexpr MessageText kDraftTaskOf{"draft_task_of", "Prepare the cavity that is outlined, %1 mm deep.",
                                          "外形線の窩洞を、深さ %1 mm に形成します。"};

}  // namespace tactooth::msg
