// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/message.h"

/// The catalogue of this layer: what it says to people, in both languages.
namespace tactooth::msg {

// Recordings.
inline constexpr MessageText kRecordingRate{
    "recording_rate", "%1: the recording has %2 samples a second, but 4000 to 192000 are needed; save it at 48000.",
    "%1：録音のサンプリング周波数が %2 Hz です。4000～192000 Hz が必要です。48000 Hz で保存してください。"};
inline constexpr MessageText kRecordingLength{
    "recording_length", "%1: the recording lasts %2 s, but a loop needs 0.05 to 30 s; cut out a steady piece.",
    "%1：録音の長さが %2 秒です。ループには 0.05～30 秒が必要です。音の安定した部分を切り出してください。"};
inline constexpr MessageText kRecordingNotFinite{
    "recording_not_finite", "%1: sample %2 is not a finite number; save the recording again.",
    "%1：%2 番目のサンプルが有限の数値ではありません。録音を保存し直してください。"};
inline constexpr MessageText kRecordingSilent{
    "recording_silent", "%1: the recording is silent or far too loud to be one; record it again.",
    "%1：録音が無音か、録音とは思えないほど大きな音です。録音し直してください。"};
inline constexpr MessageText kRecordingFormat{
    "recording_format", "%1: this is neither WAV, FLAC nor Ogg; save the recording as one of these.",
    "%1：WAV、FLAC、Ogg のいずれでもありません。録音をいずれかの形式で保存してください。"};
inline constexpr MessageText kRecordingChannels{
    "recording_channels", "%1: the recording has %2 channels, but 1 to 8 are expected; save it with one.",
    "%1：録音のチャンネル数が %2 です。1～8 でなければなりません。モノラルで保存してください。"};
inline constexpr MessageText kRecordingTooLong{
    "recording_too_long", "%1: the recording lasts longer than the 30 s of a loop; cut out a steady piece.",
    "%1：録音がループの上限の 30 秒を超えています。音の安定した部分を切り出してください。"};
inline constexpr MessageText kRecordingCutOff{
    "recording_cut_off", "%1: the file is shorter than it says; it was cut off, so copy or record it again.",
    "%1：ファイルが本来より短く、途中で切れています。コピーし直すか、録音し直してください。"};
inline constexpr MessageText kRecordingDamaged{
    "recording_damaged", "%1: the file breaks off or is damaged (%2); copy or record it again.",
    "%1：ファイルが途中で切れているか、壊れています（%2）。コピーし直すか、録音し直してください。"};
inline constexpr MessageText kRecordingNotRead{
    "recording_not_read", "%1: this is not a recording that can be read (%2); save it as WAV, FLAC or Ogg.",
    "%1：読み込める録音ではありません（%2）。WAV、FLAC、Ogg のいずれかで保存してください。"};

// Sound that is rendered into a file.
inline constexpr MessageText kWavTooLong{
    "wav_too_long", "The sound could not be made into a WAV file, which holds at most 4 GB; make it shorter.",
    "音を WAV ファイルにできませんでした。WAV ファイルは 4 GB までです。短くしてください。"};
inline constexpr MessageText kSoundLength{
    "sound_length", "The length of the sound has to be more than 0 and at most %1 s, but is %2 s.",
    "音の長さは 0 秒より長く、%1 秒以下でなければなりませんが、%2 秒です。"};
inline constexpr MessageText kSoundOfNothing{"sound_of_nothing",
                                             "There is nothing to make a sound of: the session has no moment at all.",
                                             "音にするものがありません。セッションに時刻が一つもありません。"};
inline constexpr MessageText kSoundBackwards{
    "sound_backwards", "The times of the sound's states may not run backwards, but number %1 is at %2 s.",
    "音の状態の時刻は逆戻りできませんが、%1 番目の時刻は %2 秒です。"};
inline constexpr MessageText kNoLoopback{
    "no_loopback", "OpenAL has no loopback device (ALC_SOFT_loopback) to render to; install OpenAL Soft.",
    "OpenAL に、音を書き出すためのループバック装置（ALC_SOFT_loopback）がありません。OpenAL Soft "
    "をインストールしてください。"};

// States of the sound.
inline constexpr MessageText kSoundStarting{"sound_starting", "sound starting", "音を準備中"};
inline constexpr MessageText kSoundOn{"sound_on", "sound on", "音あり"};
inline constexpr MessageText kNoSoundCard{"no_sound_card", "no sound card: silent", "サウンドカードなし：無音"};

}  // namespace tactooth::msg
