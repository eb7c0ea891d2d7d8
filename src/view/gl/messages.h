// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/message.h"

/// The catalogue of this layer: what it says to people, in both languages.
namespace tactooth::msg {

// Drawing.
inline constexpr MessageText kNoOffscreenOpenGl{
    "no_offscreen_open_gl",
    "no OpenGL 4.1 without a screen was found on this computer: install the packages libegl1 and "
    "libgl1-mesa-dri, which draw without a graphics card",
    "このコンピューターに、画面なしで使える OpenGL 4.1 が見つかりません。グラフィックスカードなしで描画できる "
    "libegl1 と libgl1-mesa-dri のパッケージをインストールしてください"};
inline constexpr MessageText kOpenGlError{
    "open_gl_error",
    "OpenGL reported \"%1\" while %2: update the graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1 to draw without it",
    "OpenGL がエラー \"%1\" を報告しました（処理：%2）。グラフィックスドライバーを更新するか、"
    "LIBGL_ALWAYS_SOFTWARE=1 を設定してドライバーなしで描画してください"};
inline constexpr MessageText kPictureRefused{
    "picture_refused", "the graphics driver cannot draw into a picture of %1 x %2 pixels: choose a smaller size",
    "グラフィックスドライバーは %1 x %2 ピクセルの画像に描画できません。小さい大きさを選んでください"};
inline constexpr MessageText kShaderRefused{
    "shader_refused",
    "the graphics driver cannot %1 the shader \"%2\" (%3): update the driver, or set LIBGL_ALWAYS_SOFTWARE=1 to "
    "draw without it",
    "グラフィックスドライバーがシェーダー \"%2\" を%1できません（%3）。ドライバーを更新するか、"
    "LIBGL_ALWAYS_SOFTWARE=1 を設定してドライバーなしで描画してください"};
inline constexpr MessageText kCompile{"compile", "compile", "コンパイル"};
inline constexpr MessageText kLink{"link", "link", "リンク"};
inline constexpr MessageText kPictureNotEncoded{"picture_not_encoded",
                                                "cannot encode the picture %1 (%2): choose a smaller size",
                                                "画像 %1 を符号化できません（%2）。小さい大きさを選んでください"};
inline constexpr MessageText kPictureNotRead{"picture_not_read", "cannot read the picture %1 (%2): give a PNG file",
                                             "画像 %1 を読めません（%2）。PNG ファイルを指定してください"};
inline constexpr MessageText kPictureDamaged{"picture_damaged", "the picture %1 is damaged (%2): save it again",
                                             "画像 %1 が壊れています（%2）。保存し直してください"};
inline constexpr MessageText kPictureSize{"picture_size",
                                          "a picture of %1 x %2 pixels cannot be drawn: choose 1 to %3 for each side.",
                                          "%1 x %2 ピクセルの画像は描画できません。各辺は 1 から %3 までです。"};
inline constexpr MessageText kOpenGlTooOld{
    "open_gl_too_old",
    "this computer offers OpenGL %1.%2, but OpenGL 4.1 or newer is needed: update the graphics driver, or set "
    "LIBGL_ALWAYS_SOFTWARE=1 to draw without it",
    "このコンピューターの OpenGL は %1.%2 ですが、OpenGL 4.1 以降が必要です。"
    "グラフィックスドライバーを更新するか、LIBGL_ALWAYS_SOFTWARE=1 を設定してドライバーなしで描画してください"};

// What OpenGL was asked to do.
inline constexpr MessageText kMakingPictureOf{"making_picture_of", "making a picture of %1 x %2 pixels",
                                              "%1 x %2 ピクセルの画像の作成"};
inline constexpr MessageText kMakingPicture{"making_picture", "making a picture", "画像の作成"};
inline constexpr MessageText kReadingPicture{"reading_picture", "reading the picture back", "画像の読み戻し"};
inline constexpr MessageText kDrawingColour{"drawing_colour", "drawing in one colour", "単色の描画"};
inline constexpr MessageText kStartingRenderer{"starting_renderer", "starting the renderer", "レンダラーの開始"};
inline constexpr MessageText kDrawingPicture{"drawing_picture", "drawing the picture", "画像の描画"};
inline constexpr MessageText kMakingShadowMap{"making_shadow_map", "making the shadow map", "シャドウマップの作成"};
inline constexpr MessageText kPreparingOcclusion{"preparing_occlusion", "preparing ambient occlusion",
                                                 "アンビエントオクルージョンの準備"};

}  // namespace tactooth::msg
