// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tactooth {

/// `text` as valid UTF-8: each invalid byte becomes U+FFFD. File names may hold any bytes.
[[nodiscard]] std::string validUtf8(std::string_view text);

/// `text` in Unicode's form NFC: letters and their marks are composed. macOS decomposes file names, other systems do
/// not; composed names compare equal. A text that is not UTF-8 stays as it is.
[[nodiscard]] std::string composed(std::string_view text);

}  // namespace tactooth
