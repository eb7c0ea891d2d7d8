// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "geometry/util/message.h"

namespace tactooth {

/// One cell of a CSV table. A text that a spreadsheet would take as a formula begins with an apostrophe.
[[nodiscard]] std::string csvCell(std::string text);

/// A text from a file, on one line and without control characters, as text of a page.
[[nodiscard]] std::string htmlText(std::string_view text);

/// The attribute lang of a page: "en".
[[nodiscard]] constexpr std::string_view languageCode(Language language) {
    return language == Language::Japanese ? "ja" : "en";
}

}  // namespace tactooth
