// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tactooth {

/// One cell of a CSV table. A text that a spreadsheet would take as a formula begins with an apostrophe.
[[nodiscard]] std::string csvCell(std::string text);

/// A text from a file, on one line and without control characters, as text of a page.
[[nodiscard]] std::string htmlText(std::string_view text);

}  // namespace tactooth
