// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "geometry/util/message.h"

namespace tactooth {

/// The fonts of pages and their drawings, for both languages.
inline constexpr std::string_view kPageFonts =
    "Noto Sans, Helvetica Neue, Arial, Hiragino Sans, Yu Gothic, Noto Sans CJK JP, IPAexGothic, IPAGothic, sans-serif";

/// A page up to the beginning of its body. `title`: text, not yet of a page. `style`: CSS besides the fonts.
[[nodiscard]] std::string pageHead(std::string_view title, std::string_view style, Language language);

}  // namespace tactooth
