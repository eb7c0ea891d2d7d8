// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/message.h"

/// The catalogue of this layer: what it says to people, in both languages.
namespace tactooth::msg {

// Recording.
inline constexpr MessageText kJournalExists{
    "journal_exists", "%1: there is a file of this name, and a recording replaces none; choose another name.",
    "%1：この名前のファイルがすでにあります。記録は既存のファイルを置き換えません。別の名前を選んでください。"};
inline constexpr MessageText kJournalNotReplaced{
    "journal_not_replaced",
    "%1: there is something of this name that is no recording, and a recording does not replace it; choose another "
    "name.",
    "%1：この名前のものがすでにあり、記録ではないため置き換えません。別の名前を選んでください。"};
inline constexpr MessageText kJournalInUse{
    "journal_in_use", "%1: another program is recording into this file; choose another name.",
    "%1：別のプログラムがこのファイルに記録しています。別の名前を選んでください。"};
inline constexpr MessageText kJournalStopped{
    "journal_stopped", "%1: recording stopped (%2); the session goes on, and what was recorded before is kept.",
    "%1：記録が止まりました（%2）。セッションは続いており、それまでの記録は残っています。"};
inline constexpr MessageText kJournalDeleted{
    "journal_deleted", "%1: recording stopped, because the file was deleted; the session goes on without a recording.",
    "%1：ファイルが削除されたため、記録が止まりました。セッションは記録なしで続いています。"};
inline constexpr MessageText kJournalFull{
    "journal_full",
    "%1: recording stopped, because the file has the %2 blocks that it may have; the session goes on, and what was "
    "recorded before is kept.",
    "%1：ファイルのブロック数が上限の %2 個に達したため、記録が止まりました。セッションは続いており、"
    "それまでの記録は残っています。"};

// Opening a recording.
inline constexpr MessageText kNoJournal{
    "no_journal", "%1: this is no recording of a session; choose a file that ends in .ttsession.",
    "%1：これはセッションの記録ではありません。末尾が .ttsession のファイルを選んでください。"};
inline constexpr MessageText kJournalOtherVersion{
    "journal_other_version",
    "%1: the recording has format version %2, but this program reads version %3; open it with the version of Tactooth "
    "that recorded it.",
    "%1：記録の形式はバージョン %2 ですが、このプログラムが読めるのはバージョン %3 です。記録したときのバージョンの "
    "Tactooth で開いてください。"};
inline constexpr MessageText kJournalHeadDamaged{
    "journal_head_damaged",
    "%1: the head of the recording is damaged or cut short, so the rest cannot be understood; use a copy of the file.",
    "%1：記録の先頭部分が壊れているか途中で切れているため、残りを解釈できません。ファイルの控えを使ってください。"};
inline constexpr MessageText kJournalTooManyBlocks{
    "journal_too_many_blocks", "%1: the recording has more than %2 blocks, which no session needs; use another file.",
    "%1：記録のブロックが %2 個を超えています。通常のセッションではありえない数です。別のファイルを使ってください。"};
inline constexpr MessageText kJournalBlockUnreadable{
    "journal_block_unreadable",
    "%1: the block at byte %2 is damaged or has changed since the file was opened; repair the recording.",
    "%1：%2 バイト目のブロックが壊れているか、ファイルを開いた後に変わりました。記録を修復してください。"};
inline constexpr MessageText kJournalAttachmentMissing{
    "journal_attachment_missing",
    "%1: the recording does not hold all of '%2', which it needs; use a copy of the file.",
    "%1：記録に必要な '%2' の全体が入っていません。ファイルの控えを使ってください。"};
inline constexpr MessageText kJournalAttachmentTooLong{
    "journal_attachment_too_long", "%1: '%2' in the recording has %3 bytes, and at most %4 are read; use another file.",
    "%1：記録の中の '%2' は %3 バイトありますが、%4 バイトまでしか読み込めません。別のファイルを使ってください。"};

// Trimming a recording.
inline constexpr MessageText kJournalTrimEmpty{
    "journal_trim_empty", "%1: the recording has nothing between the ticks %2 and %3; choose a part of it.",
    "%1：ティック %2 から %3 の間には記録がありません。記録の範囲内から選んでください。"};

}  // namespace tactooth::msg
