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
inline constexpr MessageText kSealKeyForm{
    "seal_key_form",
    "--key %1 is no public key, which has 64 hexadecimal digits; take the one that 'tactooth session key' shows on the "
    "station.",
    "--key %1 は公開鍵ではありません。公開鍵は 16 進数で 64 桁です。その端末で 'tactooth session key' "
    "が示す鍵を使ってください。"};
inline constexpr MessageText kFilmNotStarted{
    "film_not_started", "%1: the film cannot be made, because ffmpeg (%2) does not start; reinstall ffmpeg.",
    "%1：ffmpeg（%2）を起動できないため、動画を作れません。ffmpeg を入れ直してください。"};
inline constexpr MessageText kFilmFailed{"film_failed", "%1: ffmpeg could not make the film; it said: %2",
                                         "%1：ffmpeg で動画を作れませんでした。ffmpeg のメッセージ：%2"};
inline constexpr MessageText kFilmEnding{"film_ending", "%1: the name of a film ends in .mp4, .mkv or .mov.",
                                         "%1：動画のファイル名は .mp4、.mkv、.mov のいずれかで終わります。"};
inline constexpr MessageText kFilmTooLong{
    "film_too_long",
    "the film would have %1 pictures, and %2 are the most; choose a smaller --fps or --until, or a larger "
    "--speed.",
    "動画の画像が %1 枚になりますが、%2 枚までです。--fps か --until を小さくするか、--speed "
    "を大きくしてください。"};
inline constexpr MessageText kFilmEmpty{"film_empty", "%1: there is nothing to show: this recording has no ticks.",
                                        "%1：この記録には動きがないため、見せるものがありません。"};
inline constexpr MessageText kFilmOddSize{"film_odd_size", "%1 is no size for a film: width and height must be even.",
                                          "%1 は動画の大きさにできません。幅と高さは偶数にしてください。"};

}  // namespace tactooth::msg
