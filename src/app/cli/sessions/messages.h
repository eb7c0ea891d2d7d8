// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/util/message.h"

/// The catalogue of this folder: what it says to people, in both languages.
namespace tactooth::msg {

inline constexpr MessageText kTrimBackwards{
    "trim_backwards", "--from %1 is not before --to %2; choose an earlier start.",
    "--from %1 が --to %2 より前ではありません。もっと早い開始時刻を選んでください。"};
inline constexpr MessageText kTrimBehindEnd{
    "trim_behind_end", "%1: the recording ends at %2 s, before --from; choose an earlier start.",
    "%1：記録は %2 秒で終わっており、--from より前です。もっと早い開始時刻を選んでください。"};
inline constexpr MessageText kTrimNoKeyframe{
    "trim_no_keyframe",
    "%1: a part of this recording can only be replayed from its beginning, because it has no keyframe at or before %2 "
    "s; "
    "leave out --from.",
    "%1：%2 秒以前にキーフレームがないため、この記録の一部は先頭からしか再生できません。--from を省いてください。"};

}  // namespace tactooth::msg
