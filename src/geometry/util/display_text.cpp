// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// UTF-8 according to The Unicode Standard 15, table 3-7: no overlong forms and no surrogates.
#include "geometry/util/display_text.h"

#include <limits>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

struct Character {
    char32_t code;
    std::size_t bytes;  // 0: the first byte does not begin a character
};

Character characterAt(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    TACTOOTH_ASSERT(!text.empty());
    const unsigned char first = byte(0);
    if (first < 0x80) return {first, 1};
    const std::size_t bytes = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4 || text.size() < bytes) return {0, 0};
    char32_t code = first & (0xFF >> (bytes + 1));
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xC0) != 0x80) return {0, 0};
        code = code << 6 | (byte(i) & 0x3F);
    }
    const bool isOverlong = (bytes == 3 && code < 0x800) || (bytes == 4 && code < 0x10000);
    if (isOverlong || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) return {0, 0};
    return {code, bytes};
}

/// Whether a terminal obeys the character instead of showing it, or the character changes the order of others.
bool isCommand(char32_t code) {
    return code < 0x20 || (code >= 0x7F && code <= 0x9F) ||      // C0, DEL, C1
           code == 0x61C || code == 0x200E || code == 0x200F ||  // direction marks
           (code >= 0x2028 && code <= 0x202E) ||                 // line separators, embeddings, overrides
           (code >= 0x2066 && code <= 0x2069);                   // isolates
}

std::string shown(std::string_view text, std::size_t most) {
    std::string result;
    for (std::size_t count = 0; !text.empty(); ++count) {
        if (count == most) return result + "...";
        const auto [code, bytes] = characterAt(text);
        if (bytes == 0) {
            result += "\xEF\xBF\xBD";  // U+FFFD
        } else if (isCommand(code)) {
            result += '?';
        } else {
            result += text.substr(0, bytes);
        }
        text.remove_prefix(bytes == 0 ? 1 : bytes);
    }
    return result;
}

}  // namespace

std::string displayText(std::string_view text) { return shown(text, std::numeric_limits<std::size_t>::max()); }

bool isShownAsItIs(std::string_view text) {
    while (!text.empty()) {
        const auto [code, bytes] = characterAt(text);
        if (bytes == 0 || isCommand(code)) return false;
        text.remove_prefix(bytes);
    }
    return true;
}

std::string displayShort(std::string_view text, std::size_t most) { return shown(text, most); }

}  // namespace tactooth
