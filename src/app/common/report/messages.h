// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/util/message.h"

/// The catalogue of this folder: what it says to people, in both languages.
namespace tactooth::msg {

inline constexpr MessageText kNoJapaneseFont{
    "no_japanese_font",
    "a report in Japanese needs a font with Japanese letters, and this computer has none; install the package "
    "fonts-ipafont-gothic.",
    "日本語の評価書には日本語の文字のあるフォントが必要ですが、このコンピューターにはありません。"
    "パッケージ fonts-ipafont-gothic をインストールしてください。"};

}  // namespace tactooth::msg
