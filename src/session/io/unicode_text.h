// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tactooth {

/// `text` as valid UTF-8: each byte that is none becomes U+FFFD. File names may hold any bytes; a text may not.
[[nodiscard]] std::string validUtf8(std::string_view text);

/// `text` with letters and their marks composed (Unicode's form NFC), so that a name is the same whether it comes from
/// a Mac, which takes the umlaut apart, or from elsewhere. What is no UTF-8 stays as it is.
[[nodiscard]] std::string composed(std::string_view text);

}  // namespace tactooth
