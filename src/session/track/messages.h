// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/message.h"

/// The catalogue of this folder: what it says to people, in both languages.
namespace tactooth::msg {

inline constexpr MessageText kTrackBur{"track_bur", "bur put in", "バーを装着"};
inline constexpr MessageText kTrackUndo{"track_undo", "undo", "元に戻す"};
inline constexpr MessageText kTrackRedo{"track_redo", "redo", "やり直し"};
inline constexpr MessageText kTrackReset{"track_reset", "tooth put back", "歯を元の状態に"};

inline constexpr MessageText kCommentsJson{
    "comments_json", "%1: the comments in this file are damaged: they are not JSON; mend it or move it away.",
    "%1：このファイルのコメントが壊れています（JSON ではありません）。直すか、別の場所に移してください。"};
inline constexpr MessageText kCommentsEntry{
    "comments_entry",
    "%1: comment %2 in this file is damaged: it needs a 'time_s' from 0 to 1,000,000 and a 'text'; mend the file or "
    "move "
    "it away.",
    "%1：このファイルのコメント %2 が壊れています（0 から 1,000,000 までの 'time_s' と 'text' "
    "が必要です）。ファイルを直すか、別の場所に移してください。"};
inline constexpr MessageText kCommentsTooMany{
    "comments_too_many", "%1: this file has more than %2 comments; move it away.",
    "%1：このファイルのコメントは %2 件を超えています。別の場所に移してください。"};

}  // namespace tactooth::msg
