// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/message.h"

/// The catalogue of this layer: what it says to people, in both languages.
namespace tactooth::msg {

// Composition.
inline constexpr MessageText kNamed{"named", "%1: %2.", "%1：%2。"};
inline constexpr MessageText kNamedSentence{"named_sentence", "%1: %2", "%1：%2"};
inline constexpr MessageText kAtLine{"at_line", "%1, line %2: %3.", "%1、%2 行目：%3。"};

// Reading and writing files.
inline constexpr MessageText kFileMissing{"file_missing", "%1: there is no such file; check the name and the folder.",
                                          "%1：ファイルがありません。名前とフォルダーを確かめてください。"};
inline constexpr MessageText kFileNotReadable{
    "file_not_readable", "%1: this user may not read the file; change its permissions.",
    "%1：このユーザーにはファイルを読む権限がありません。アクセス権を変えてください。"};
inline constexpr MessageText kFileNotOpened{"file_not_opened", "%1: the file cannot be opened: %2.",
                                            "%1：ファイルを開けません：%2。"};
inline constexpr MessageText kReadingStopped{"reading_stopped", "%1: reading stopped: %2.",
                                             "%1：読み込みが止まりました：%2。"};
inline constexpr MessageText kFileIsFolder{"file_is_folder", "%1: this is a folder; name a file inside it.",
                                           "%1：これはフォルダーです。中のファイルを指定してください。"};
inline constexpr MessageText kFileNotRegular{
    "file_not_regular", "%1: this is not a regular file (a device or a pipe); name a file on disk.",
    "%1：通常のファイルではありません（デバイスまたはパイプです）。ディスク上のファイルを指定してください。"};
inline constexpr MessageText kFileEmpty{"file_empty", "%1: the file is empty; export or copy it again.",
                                        "%1：ファイルが空です。書き出し直すか、コピーし直してください。"};
inline constexpr MessageText kFileTooLong{
    "file_too_long",
    "%1: the file holds %2 bytes, and at most %3 are read of such a file; choose another or a smaller one.",
    "%1：ファイルは %2 バイトありますが、この種のファイルは %3 バイトまでしか読み込めません。別のファイルか、"
    "小さいファイルを選んでください。"};
inline constexpr MessageText kFileTooLargeForMemory{"file_too_large_for_memory",
                                                    "%1: the file (%2 bytes) does not fit into memory.",
                                                    "%1：ファイル（%2 バイト）がメモリーに収まりません。"};
inline constexpr MessageText kOutputIsInput{
    "output_is_input", "%1: cannot be written: this command reads it (as %2); choose another name.",
    "%1：書き込めません。このコマンドが読み込むファイルです（%2）。別の名前を選んでください。"};
inline constexpr MessageText kOutputNamedTwice{
    "output_named_twice",
    "%1: cannot be written: it is the same file as %2, which this command writes as well; choose another name.",
    "%1：書き込めません。このコマンドが書き込む %2 と同じファイルです。別の名前を選んでください。"};
inline constexpr MessageText kOutputFolderMissing{
    "output_folder_missing", "%1: cannot be written: its folder does not exist; make the folder first.",
    "%1：書き込めません。フォルダーがありません。先にフォルダーを作ってください。"};
inline constexpr MessageText kOutputFolderNotWritable{
    "output_folder_not_writable", "%1: cannot be written: this user may not write into its folder; choose another one.",
    "%1：書き込めません。このユーザーにはフォルダーへ書き込む権限がありません。別のフォルダーを選んでください。"};
inline constexpr MessageText kOutputNotWritten{"output_not_written", "%1: cannot be written: %2.",
                                               "%1：書き込めません：%2。"};
inline constexpr MessageText kOutputIsFolder{
    "output_is_folder", "%1: cannot be written: this is a folder; name a file inside it.",
    "%1：書き込めません。これはフォルダーです。中のファイルを指定してください。"};
inline constexpr MessageText kOutputNotRegular{
    "output_not_regular", "%1: cannot be written: this is not a regular file; choose another name.",
    "%1：書き込めません。通常のファイルではありません。別の名前を選んでください。"};
inline constexpr MessageText kOutputFolderNotMade{
    "output_folder_not_made", "the folder %1 cannot be made (%2); give one that you may write to.",
    "フォルダー %1 を作れません（%2）。書き込めるフォルダーを指定してください。"};
inline constexpr MessageText kFolderNotRead{"folder_not_read", "%1: the folder cannot be read (%2).",
                                            "%1：フォルダーを読めません（%2）。"};
inline constexpr MessageText kFolderNotMade{"folder_not_made", "%1: the folder cannot be made (%2).",
                                            "%1：フォルダーを作れません（%2）。"};
inline constexpr MessageText kTextInUtf16{"text_in_utf16", "%1: this is text in UTF-16; save it as UTF-8.",
                                          "%1：これは UTF-16 のテキストです。UTF-8 で保存してください。"};

// Reasons of the system.
inline constexpr MessageText kNotPermitted{"not_permitted", "Operation not permitted", "操作が許可されていません"};
inline constexpr MessageText kNoSuchFile{"no_such_file", "No such file or directory",
                                         "ファイルやフォルダーがありません"};
inline constexpr MessageText kInputOutputError{"input_output_error", "Input/output error", "入出力エラー"};
inline constexpr MessageText kNoMemory{"no_memory", "Cannot allocate memory", "メモリーを確保できません"};
inline constexpr MessageText kPermissionDenied{"permission_denied", "Permission denied", "アクセス権がありません"};
inline constexpr MessageText kBusy{"busy", "Device or resource busy", "使用中です"};
inline constexpr MessageText kFileExists{"file_exists", "File exists", "同じ名前のファイルがあります"};
inline constexpr MessageText kNotFolder{"not_folder", "Not a directory", "フォルダーではありません"};
inline constexpr MessageText kIsFolder{"is_folder", "Is a directory", "フォルダーです"};
inline constexpr MessageText kTooManyOpenFiles{"too_many_open_files", "Too many open files",
                                               "開いているファイルが多すぎます"};
inline constexpr MessageText kFileTooLarge{"file_too_large", "File too large", "ファイルが大きすぎます"};
inline constexpr MessageText kNoSpace{"no_space", "No space left on device", "ディスクの空き容量がありません"};
inline constexpr MessageText kReadOnly{"read_only", "Read-only file system", "読み取り専用のディスクです"};
inline constexpr MessageText kBrokenPipe{"broken_pipe", "Broken pipe", "パイプの読み手がいません"};
inline constexpr MessageText kNameTooLong{"name_too_long", "File name too long", "ファイル名が長すぎます"};
inline constexpr MessageText kFolderNotEmpty{"folder_not_empty", "Directory not empty", "フォルダーが空ではありません"};
inline constexpr MessageText kTooManyLinks{"too_many_links", "Too many levels of symbolic links",
                                           "シンボリックリンクの段数が多すぎます"};
inline constexpr MessageText kQuotaExceeded{"quota_exceeded", "Disk quota exceeded",
                                            "ディスクの割り当て容量を超えました"};

// Surfaces.
inline constexpr MessageText kSurfaceTooFar{
    "surface_too_far",
    "%1: the surface lies too far from zero for single precision, in which its place is needed; move it near to "
    "zero, or make a case of it with 'tactooth case new'.",
    "%1：表面が原点から遠すぎて、位置を単精度で表せません。原点の近くに移すか、'tactooth case new' "
    "で症例にしてください。"};
inline constexpr MessageText kFormatNotRead{
    "format_not_read", "%1: %2 files cannot be read; export the surface as STL, OBJ or PLY.",
    "%1：%2 ファイルは読めません。表面を STL、OBJ、PLY のいずれかで書き出してください。"};
inline constexpr MessageText kReachesTooFar{
    "reaches_too_far",
    "%1 reaches %2 mm from its origin, farther than anything can be felt or cut (1 km): look for a stray corner, "
    "or check the unit",
    "%1が原点から %2 mm 離れています。触れたり削ったりできる範囲（1 km）を超えています。はぐれた頂点がないか、"
    "単位が正しいかを確かめてください"};
inline constexpr MessageText kTheSurface{"the_surface", "the surface", "表面"};
inline constexpr MessageText kSurfaceOf{"surface_of", "the surface of %1", "%1の表面"};
inline constexpr MessageText kNoTriangles{"no_triangles", "%1: the file holds no triangles; export the surface again.",
                                          "%1：ファイルに三角形がありません。表面を書き出し直してください。"};
inline constexpr MessageText kOutlineCrossesItself{"outline_crosses_itself", "the outline of the face crosses itself",
                                                   "面の輪郭が自分自身と交わっています"};
inline constexpr MessageText kFaceTooLarge{"face_too_large", "the face has too many corners to be split into triangles",
                                           "面の頂点が多すぎて三角形に分けられません"};
inline constexpr MessageText kExpectedFinite{"expected_finite", "expected a finite coordinate", "有限の座標が必要です"};

// STL.
inline constexpr MessageText kStlCornerNotFinite{
    "stl_corner_not_finite",
    "%1: triangle %2 (byte %3) has a corner that is not a finite number; repair or export the surface again.",
    "%1：三角形 %2（%3 バイト目）の頂点が有限の数値ではありません。表面を修復するか、書き出し直してください。"};
inline constexpr MessageText kStlRefused{"stl_refused", "%1, line %2: %3, but %4; repair or export the surface again.",
                                         "%1、%2 行目：%3。%4。表面を修復するか、書き出し直してください。"};
inline constexpr MessageText kStlExpectedSolid{"stl_expected_solid", "expected 'solid' or the end of the file",
                                               "'solid' またはファイルの終わりが必要です"};
inline constexpr MessageText kStlExpectedFacet{"stl_expected_facet", "expected 'facet' or 'endsolid'",
                                               "'facet' または 'endsolid' が必要です"};
inline constexpr MessageText kStlExpectedNormal{"stl_expected_normal", "expected the facet's normal",
                                                "面の法線が必要です"};
inline constexpr MessageText kStlExpectedCoordinate{"stl_expected_coordinate",
                                                    "expected a coordinate (a number with '.' as decimal point)",
                                                    "座標（小数点に '.' を使った数値）が必要です"};
inline constexpr MessageText kStlExpectedWord{"stl_expected_word", "expected '%1'", "'%1' が必要です"};
inline constexpr MessageText kFound{"found", "found %1", "見つかったのは %1 です"};
inline constexpr MessageText kFileEnds{"file_ends", "the file ends: it is cut short", "ファイルが途中で切れています"};
inline constexpr MessageText kNotStl{"not_stl", "%1: this is %2, not an STL surface; export the surface as STL.",
                                     "%1：これは%2で、STL の表面ではありません。表面を STL で書き出してください。"};
inline constexpr MessageText kPlyMesh{"ply_mesh", "a PLY mesh", "PLY メッシュ"};
inline constexpr MessageText kZipArchive{"zip_archive", "a ZIP archive", "ZIP アーカイブ"};
inline constexpr MessageText kGzipArchive{"gzip_archive", "a gzip archive", "gzip アーカイブ"};
inline constexpr MessageText kPngPicture{"png_picture", "a PNG picture", "PNG 画像"};
inline constexpr MessageText kOffMesh{"off_mesh", "an OFF mesh", "OFF メッシュ"};
inline constexpr MessageText kJpegPicture{"jpeg_picture", "a JPEG picture", "JPEG 画像"};
inline constexpr MessageText kPdfDocument{"pdf_document", "a PDF document", "PDF 文書"};
inline constexpr MessageText kProgram{"program", "a program", "プログラム"};
inline constexpr MessageText kDicomImage{"dicom_image", "a DICOM image", "DICOM 画像"};
inline constexpr MessageText kMacNotes{"mac_notes", "a Mac's notes on a file of this name",
                                       "この名前のファイルについての Mac の覚え書き"};
inline constexpr MessageText kTextWithoutSolid{"text_without_solid", "text that does not begin with 'solid'",
                                               "'solid' で始まらないテキスト"};
inline constexpr MessageText kUnknownBinary{"unknown_binary", "unknown binary data", "不明なバイナリデータ"};
inline constexpr MessageText kStlWrongCount{
    "stl_wrong_count",
    "%1: %2: its header announces %3 triangles, which take %4 bytes, but the file has %5; export or copy it "
    "again.",
    "%1：%2。ヘッダーによれば三角形は %3 個、大きさは %4 バイトですが、ファイルは %5 バイトです。書き出し直すか、"
    "コピーし直してください。"};
inline constexpr MessageText kStlCutShort{"stl_cut_short", "the file is cut short or its count is wrong",
                                          "ファイルが途中で切れているか、個数が誤っています"};
inline constexpr MessageText kStlTooLong{"stl_too_long", "the file is longer than its triangle count says",
                                         "ファイルが三角形の個数に対して長すぎます"};
inline constexpr MessageText kStlTooShort{
    "stl_too_short",
    "%1: the file is too short for an STL surface: it has %2 bytes and a binary one needs at least %3; export or "
    "copy it again.",
    "%1：STL の表面としてはファイルが短すぎます。バイナリー形式には少なくとも %3 バイトが必要ですが、%2 "
    "バイトしかありません。書き出し直すか、コピーし直してください。"};

// OBJ.
inline constexpr MessageText kObjRefused{"obj_refused", "%1, line %2: %3; repair or export the surface again.",
                                         "%1、%2 行目：%3。表面を修復するか、書き出し直してください。"};
inline constexpr MessageText kObjNoFaces{"obj_no_faces",
                                         "%1: the file holds no faces; export the surface again, as triangles.",
                                         "%1：ファイルに面がありません。表面を三角形で書き出し直してください。"};
inline constexpr MessageText kObjCoordinateFound{"obj_coordinate_found", "expected a finite coordinate, but found %1",
                                                 "有限の座標が必要ですが、見つかったのは %1 です"};
inline constexpr MessageText kObjVertexFound{
    "obj_vertex_found", "expected the number of a vertex that the file has given above, but found %1",
    "それまでに出てきた頂点の番号が必要ですが、見つかったのは %1 です"};
inline constexpr MessageText kObjFewCorners{"obj_few_corners", "expected a face of three corners or more",
                                            "三つ以上の頂点を持つ面が必要です"};

// PLY.
inline constexpr MessageText kPlyNoFormat{"ply_no_format",
                                          "%1: the PLY header names no format; export the surface again.",
                                          "%1：PLY のヘッダーに形式が書かれていません。表面を書き出し直してください。"};
inline constexpr MessageText kPlyExpectedHeaderLine{
    "ply_expected_header_line", "%1, line %2: expected a line of a PLY header, but found %3; export the surface again.",
    "%1、%2 行目：PLY のヘッダーの行が必要ですが、見つかったのは %3 です。表面を書き出し直してください。"};
inline constexpr MessageText kPlyNoHeaderEnd{
    "ply_no_header_end", "%1: the PLY header has no end: the file is cut short; export the surface again.",
    "%1：PLY のヘッダーに終わりがありません。ファイルが途中で切れています。表面を書き出し直してください。"};
inline constexpr MessageText kPlyRefused{"ply_refused", "%1: %2; export the surface again.",
                                         "%1：%2。表面を書き出し直してください。"};
inline constexpr MessageText kPlyItemRefused{"ply_item_refused", "%1 %2: %3", "%1 %2：%3"};
inline constexpr MessageText kPlyNoFaces{"ply_no_faces", "the file holds no faces", "ファイルに面がありません"};
inline constexpr MessageText kPlyNoNumber{"ply_no_number", "the file is cut short, or holds what is no number",
                                          "ファイルが途中で切れているか、数値でないものが入っています"};
inline constexpr MessageText kPlyNotFinite{"ply_not_finite", "x, y and z are not three finite numbers",
                                           "x、y、z が三つの有限の数値ではありません"};
inline constexpr MessageText kPlyCutShort{"ply_cut_short", "the file is cut short", "ファイルが途中で切れています"};
inline constexpr MessageText kPlyListTooLong{"ply_list_too_long", "a list is longer than the file",
                                             "リストがファイルより長くなっています"};
inline constexpr MessageText kPlyNoVertex{"ply_no_vertex", "a corner names a vertex that the file does not have",
                                          "面の頂点がファイルにない頂点を指しています"};

// Import notes.
inline constexpr MessageText kNoteUnknownLine{"note_unknown_line",
                                              "%1: line %2 was not understood and passed over; it begins with %3.",
                                              "%1：%2 行目は解釈できず、読み飛ばしました（%3 で始まる行）。"};
inline constexpr MessageText kNoteUnknownLines{
    "note_unknown_lines",
    "%1: %2 lines were not understood and passed over; the first is line %3, which begins with %4.",
    "%1：%2 行は解釈できず、読み飛ばしました。最初は %3 行目で、%4 で始まります。"};
inline constexpr MessageText kNoteMoved{
    "note_moved",
    "%1: the surface lies too far from zero for single precision: %2, %3, %4 were subtracted from its "
    "coordinates before they were rounded.",
    "%1：表面が原点から遠く、単精度では足りないため、丸める前に座標から %2、%3、%4 を引きました。"};

}  // namespace tactooth::msg
