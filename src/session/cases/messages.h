// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/message.h"

/// The catalogue of this layer: what it says to people, in both languages.
namespace tactooth::msg {

// The text of a case.
inline constexpr MessageText kCaseFormatMissing{"case_format_missing",
                                                "the key 'format' is missing; this version writes 1",
                                                "キー 'format' がありません。このバージョンでは 1 を書きます"};
inline constexpr MessageText kCaseTooNew{
    "case_too_new", "the case has format %1, which is newer than this program (1); take a newer one",
    "症例の形式 %1 はこのプログラムの形式（1）より新しいものです。新しいプログラムを使ってください"};
inline constexpr MessageText kCaseNoTooth{"case_no_tooth", "there is no [[tooth]]", "[[tooth]] がありません"};
inline constexpr MessageText kCaseTooManyTeeth{"case_too_many_teeth", "there are too many teeth", "歯が多すぎます"};
inline constexpr MessageText kACase{"a_case", "a case", "症例"};
inline constexpr MessageText kABur{"a_bur", "a bur", "バー"};
inline constexpr MessageText kATooth{"a_tooth", "a tooth", "歯"};
inline constexpr MessageText kABodyAround{"a_body_around", "a body around the teeth", "歯の周囲の物体"};
inline constexpr MessageText kNoPermanentTooth{
    "no_permanent_tooth", "%1 is no permanent tooth; FDI numbers are 11-18, 21-28, 31-38 and 41-48",
    "%1 は永久歯ではありません。FDI の番号は 11～18、21～28、31～38、41～48 です"};
inline constexpr MessageText kCaseNameTooLong{"case_name_too_long", "the name must be short and without slashes",
                                              "名前は短くし、スラッシュを使わないでください"};
inline constexpr MessageText kCaseNameTwice{"case_name_twice", "the name %1 is given twice", "名前 %1 が二つあります"};
inline constexpr MessageText kCaseRotation{"case_rotation", "the rotation must be a quaternion of length 1, w first",
                                           "rotation は長さ 1 の四元数（w が先頭）でなければなりません"};
inline constexpr MessageText kCasePosition{"case_position",
                                           "the position lies more than 1000 mm away; lengths are in mm",
                                           "位置が 1000 mm より遠くにあります。長さの単位は mm です"};
inline constexpr MessageText kNoSuchBur{
    "no_such_bur",
    "%1: there is neither a bur of this number nor a file of this name; 'tactooth bur --list' shows the numbers.",
    "%1：この番号のバーも、この名前のファイルもありません。番号の一覧は 'tactooth bur --list' で分かります。"};
inline constexpr MessageText kBurMaterialUnknown{"bur_material_unknown", "'material' must be carbide or diamond",
                                                 "'material' は carbide か diamond でなければなりません"};
inline constexpr MessageText kBurSurfaceElsewhere{
    "bur_surface_elsewhere", "the surface must lie beside this file or below it, named with '/' and without '..'",
    "表面はこのファイルと同じフォルダーかその下に置き、'/' を使い、'..' を使わずに書いてください"};

// Names of files in a case.
inline constexpr MessageText kEntryLeadsOut{
    "entry_leads_out", "%1 points out of the case; give a path inside its folder, with '/' and without '..'",
    "%1 は症例の外を指しています。'/' を使い、'..' を使わずに、フォルダー内のパスを書いてください"};
inline constexpr MessageText kEntryControlCharacters{"entry_control_characters",
                                                     "%1 has control characters in its name; give the file another one",
                                                     "%1 の名前に制御文字があります。ファイルの名前を変えてください"};
inline constexpr MessageText kEntryTooLong{"entry_too_long",
                                           "%1 is longer than 1000 bytes; give the file a shorter name",
                                           "%1 は 1000 バイトを超えています。ファイルの名前を短くしてください"};
inline constexpr MessageText kEntryNoFile{
    "entry_no_file", "%1 names no file; give a path inside the case's folder",
    "%1 はファイルの名前ではありません。症例のフォルダー内のパスを指定してください"};

// Opening a case.
inline constexpr MessageText kCaseClaimsTooMuch{
    "case_claims_too_much",
    "%1 claims to hold %2 bytes, more than the %3 that a case may; it is damaged or made to do harm.",
    "%1 は %2 バイトとなっていて、症例の上限 %3 バイトを超えています。壊れているか、悪意のあるファイルです。"};
inline constexpr MessageText kCaseFolderTooFull{
    "case_folder_too_full", "%1: the folder holds more than %2 files; give a case a folder of its own.",
    "%1：フォルダーに %2 個を超えるファイルがあります。症例には専用のフォルダーを使ってください。"};
inline constexpr MessageText kArchivePointsOut{
    "archive_points_out", "%1: the archive holds a file named '%2', which points out of it; it may be made to do harm.",
    "%1：アーカイブの外を指すファイル '%2' が入っています。悪意のあるファイルです。"};
inline constexpr MessageText kArchiveControlCharacters{
    "archive_control_characters",
    "%1: the archive holds a file named '%2', which has control characters in its name; give it another one and "
    "pack anew.",
    "%1：アーカイブの中のファイル '%2' の名前に制御文字があります。別の名前にして、もう一度まとめてください。"};
inline constexpr MessageText kArchiveNameTooLong{
    "archive_name_too_long",
    "%1: the archive holds a file named '%2', whose name is longer than 1000 bytes; give it a shorter one and "
    "pack anew.",
    "%1：アーカイブの中のファイル '%2' の名前が 1000 バイトを超えています。短い名前にして、"
    "もう一度まとめてください。"};
inline constexpr MessageText kArchiveNameTwice{
    "archive_name_twice", "%1: the archive holds two files of the same name; pack it anew.",
    "%1：アーカイブに同じ名前のファイルが二つあります。作り直してください。"};
inline constexpr MessageText kArchiveOfSeveral{
    "archive_of_several", "%1: the archive holds several cases, in %2 and %3; pack each on its own.",
    "%1：アーカイブに %2 と %3 など複数の症例が入っています。一つずつ別々にまとめてください。"};
inline constexpr MessageText kCaseFileMissing{"case_file_missing", "%1: there is no such file in the case.",
                                              "%1：症例にこのファイルはありません。"};
inline constexpr MessageText kCaseLinkLeadsOut{
    "case_link_leads_out", "%1: the link leads out of the case's folder; put a copy there instead.",
    "%1：リンクが症例のフォルダーの外を指しています。代わりにコピーを置いてください。"};
inline constexpr MessageText kCaseToothUnknown{"case_tooth_unknown",
                                               "%1: there is no tooth '%2' in this case; it has %3.",
                                               "%1：この症例に歯 '%2' はありません。あるのは %3 です。"};

// Archives.
inline constexpr MessageText kArchiveListDamaged{"archive_list_damaged", "%1: the archive's list is damaged.",
                                                 "%1：アーカイブの一覧が壊れています。"};
inline constexpr MessageText kArchiveLocked{
    "archive_locked", "%1: the file is locked with a password; pack the case without one.",
    "%1：ファイルにパスワードがかかっています。パスワードなしで症例を作り直してください。"};
inline constexpr MessageText kArchiveMethod{
    "archive_method", "%1: the file is packed in an unusual way; pack the case with 'tactooth case pack'.",
    "%1：ファイルの圧縮方式が特殊です。'tactooth case pack' で症例を作り直してください。"};
inline constexpr MessageText kArchiveBomb{
    "archive_bomb",
    "%1: the file claims to unpack from %2 to %3 bytes, more than any surface does; the archive is damaged or "
    "made to do harm.",
    "%1：%2 バイトから %3 バイトに展開されることになっていますが、どんな表面もこれほど大きくなりません。"
    "アーカイブが壊れているか、悪意のあるファイルです。"};
inline constexpr MessageText kNoArchive{"no_archive", "%1: this is no zip archive that can be read (%2).",
                                        "%1：読み込める ZIP アーカイブではありません（%2）。"};
inline constexpr MessageText kArchiveTooManyFiles{
    "archive_too_many_files", "%1: the archive holds %2 files, more than the %3 that a case may.",
    "%1：アーカイブに %2 個のファイルがあり、症例の上限 %3 個を超えています。"};
inline constexpr MessageText kArchiveTooLarge{
    "archive_too_large", "%1: the archive claims to hold %2 bytes, more than the %3 that a case may.",
    "%1：アーカイブの中身は %2 バイトとなっていて、症例の上限 %3 バイトを超えています。"};
inline constexpr MessageText kArchiveFileMissing{"archive_file_missing", "%1: there is no such file in the archive.",
                                                 "%1：アーカイブにこのファイルはありません。"};
inline constexpr MessageText kArchiveFileDamaged{"archive_file_damaged", "%1: the file is damaged inside the archive.",
                                                 "%1：アーカイブ内のファイルが壊れています。"};
inline constexpr MessageText kArchiveFileDiffers{"archive_file_differs",
                                                 "%1: the file is not what the archive's list says; it is damaged.",
                                                 "%1：ファイルがアーカイブの一覧と一致しません。壊れています。"};
inline constexpr MessageText kArchiveNoMemory{"archive_no_memory",
                                              "the case could not be packed: there is not enough memory.",
                                              "症例を作れませんでした。メモリーが足りません。"};

// Making a case.
inline constexpr MessageText kCaseOfTooMuch{"case_of_too_much", "%1: the folder holds too many surfaces for one case.",
                                            "%1：フォルダーの表面が一つの症例には多すぎます。"};
inline constexpr MessageText kCaseOfNothing{"case_of_nothing", "there is no STL, OBJ or PLY file to make a case of.",
                                            "症例にする STL、OBJ、PLY ファイルがありません。"};
inline constexpr MessageText kCaseSurfaceTwice{
    "case_surface_twice", "%1: the case has this surface already; give each tooth its own name.",
    "%1：この表面は症例にすでにあります。歯にはそれぞれ別の名前を付けてください。"};
inline constexpr MessageText kCaseWithoutTooth{
    "case_without_tooth", "none of the surfaces is a tooth; name one TOOTH.stl or TOOTH_enamel.stl.",
    "表面の中に歯がありません。TOOTH.stl や TOOTH_enamel.stl のような名前を付けてください。"};
inline constexpr MessageText kCaseSurfaceNotSolid{
    "case_surface_not_solid", "%1: %2. Leave it out, or ask for all holes to be filled.",
    "%1：%2。この表面を除くか、すべての穴をふさぐように指定してください。"};
inline constexpr MessageText kCaseSurfaceMended{"case_surface_mended", "The surface was mended.",
                                                "表面を修復しました。"};
inline constexpr MessageText kCaseSurfaceSound{"case_surface_sound", "Closed and sound as it came.",
                                               "元から閉じていて、問題はありません。"};
inline constexpr MessageText kCaseNotReadable{"case_not_readable", "the new case could not be opened: %1",
                                              "この症例は誰にも開けません：%1"};
inline constexpr MessageText kCaseTargetTaken{
    "case_target_taken", "%1: there is something already; give a new folder, or a name that ends in %2.",
    "%1：すでに何かあります。新しいフォルダーか、%2 で終わる名前を指定してください。"};

}  // namespace tactooth::msg
