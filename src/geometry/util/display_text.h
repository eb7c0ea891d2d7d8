// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tactooth {

/// Untrusted text (names of files, layers and devices, words of a file, arguments) in a form that is safe for a
/// terminal: one line of valid UTF-8. Each control character (C0, DEL, C1, line separators) and each mark that changes
/// the direction of writing becomes '?'. Each byte that is not UTF-8 becomes U+FFFD. All other characters stay as they
/// are.
[[nodiscard]] std::string displayText(std::string_view text);

/// Whether displayText leaves the text unchanged.
[[nodiscard]] bool isShownAsItIs(std::string_view text);

/// The first `most` characters of displayText, followed by "..." if there are more.
[[nodiscard]] std::string displayShort(std::string_view text, std::size_t most);

}  // namespace tactooth
