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
inline constexpr MessageText kRecordingFolderUnusable{
    "recording_folder_unusable",
    "%1: this session is not recorded, because its folder cannot be used (%2); the session goes on.",
    "%1：フォルダーが使えないため（%2）、このセッションは記録されません。セッションは続きます。"};
inline constexpr MessageText kRecordingNotRenamed{
    "recording_not_renamed", "%1: the recording is complete, but cannot be renamed (%2); it keeps this name.",
    "%1：記録は完了しましたが、名前を変更できません（%2）。この名前のまま残ります。"};
inline constexpr MessageText kRestoreStopped{
    "restore_stopped", "%1: the session was not restored, because you stopped it; the recording is kept.",
    "%1：中止したため、セッションは復元されませんでした。記録は残っています。"};
inline constexpr MessageText kRestoredInPart{
    "restored_in_part",
    "The session was restored up to %1 s of %2 s, where its replay differs from the recording; the recording is kept.",
    "セッションを %2 秒のうち %1 秒まで復元しました。その先は再生が記録と一致しません。記録は残っています。"};
inline constexpr MessageText kStationKeyDamaged{
    "station_key_damaged",
    "%1: the key of this station is damaged; put a copy of the file in its place, or move it away so that a new key is "
    "made.",
    "%1：この端末の鍵が壊れています。ファイルの控えを元の場所に戻すか、ファイルを移して新しい鍵を作らせてください。"};
inline constexpr MessageText kStationKeyReadable{
    "station_key_readable",
    "%1: other users of this computer may read the key of this station, so it proves nothing; run chmod 600 on the "
    "file.",
    "%1：この端末の鍵をほかの利用者も読めるため、証明になりません。ファイルに chmod 600 を実行してください。"};
inline constexpr MessageText kStationKeyNowhere{
    "station_key_nowhere", "There is no folder for the key of this station; set HOME or XDG_DATA_HOME.",
    "この端末の鍵を置くフォルダーがありません。HOME か XDG_DATA_HOME を設定してください。"};
inline constexpr MessageText kRecordingBurRefused{"recording_bur_refused", "%1: the bur of this recording: %2",
                                                  "%1：この記録のバー：%2"};

}  // namespace tactooth::msg
