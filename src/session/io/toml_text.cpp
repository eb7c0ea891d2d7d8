// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/io/toml_text.h"

#include "geometry/util/display_text.h"
#include "session/io/unicode_text.h"

namespace tactooth {

std::string tomlText(const std::string& text) {
    std::string result = "\"";
    for (const char letter : displayText(validUtf8(text))) {
        if (letter == '"' || letter == '\\') result += '\\';
        result += letter;
    }
    return result + '"';
}

}  // namespace tactooth
