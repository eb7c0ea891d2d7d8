// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tactooth {

/// `text` as a TOML string in quotes: valid UTF-8 (see validUtf8), with '?' for control characters.
[[nodiscard]] std::string tomlText(const std::string& text);

}  // namespace tactooth
