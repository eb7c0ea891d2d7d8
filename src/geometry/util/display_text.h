// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tactooth {

/// Text of which nobody knows where it comes from (names of files, layers and devices, words of a file, arguments) as
/// a terminal may show it: one line of valid UTF-8. Each control character (C0, DEL, C1, separators of lines) and each
/// mark that turns the direction of writing becomes '?', each byte that is not UTF-8 becomes U+FFFD; all other
/// characters stay as they are.
[[nodiscard]] std::string displayText(std::string_view text);

/// Whether displayText changes nothing.
[[nodiscard]] bool isShownAsItIs(std::string_view text);

/// The first `most` characters of displayText, with "..." behind them if there are more.
[[nodiscard]] std::string displayShort(std::string_view text, std::size_t most);

}  // namespace tactooth
