// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/message.h"

/// The catalogue of this folder: what it says to people, in both languages.
namespace tactooth::msg {

inline constexpr MessageText kRecordingSetupJson{
    "recording_setup_json",
    "%1: the settings in this recording are damaged: they are not JSON; use another copy of the file.",
    "%1：この記録の設定が壊れています（JSON ではありません）。ファイルの別のコピーを使ってください。"};
inline constexpr MessageText kRecordingSetupKey{
    "recording_setup_key",
    "%1: the settings in this recording are damaged: '%2' is missing or has no valid value; use another copy of the "
    "file.",
    "%1：この記録の設定が壊れています：'%2' がないか、値が正しくありません。ファイルの別のコピーを使ってください。"};
inline constexpr MessageText kRecordingBurMissing{
    "recording_bur_missing",
    "%1: the surface of the bur (%2) is missing in this recording or damaged; use another copy of the file.",
    "%1：この記録にはバーの表面（%2）がないか、壊れています。ファイルの別のコピーを使ってください。"};
inline constexpr MessageText kRecordingSurfaceDamaged{
    "recording_surface_damaged",
    "%1: the surface that was touched is damaged in this recording; use another copy of the file.",
    "%1：この記録では、触れた表面のデータが壊れています。ファイルの別のコピーを使ってください。"};
inline constexpr MessageText kRecordingBodyDamaged{
    "recording_body_damaged",
    "%1: body %2 around the tooth is damaged in this recording; use another copy of the file.",
    "%1：この記録では、歯の周りの物体 %2 が壊れています。ファイルの別のコピーを使ってください。"};
inline constexpr MessageText kRecordingEventsDamaged{
    "recording_events_damaged",
    "%1: the events at byte %2 of this recording are damaged, though their checksum is right; report this fault.",
    "%1：この記録の %2 バイト目の出来事は、検査値は正しいのに壊れています。この不具合を報告してください。"};
inline constexpr MessageText kRecordingOverflowed{
    "recording_overflowed",
    "The recording has a gap, because this computer was too slow for a while: its replay ends there. The session goes "
    "on.",
    "このコンピューターが一時的に遅れたため、記録に抜けがあります。再生はそこで終わります。セッションは続きます。"};
inline constexpr MessageText kRecordingBurRefused{"recording_bur_refused", "%1: the bur of this recording: %2",
                                                  "%1：この記録のバー：%2"};

}  // namespace tactooth::msg
