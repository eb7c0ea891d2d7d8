// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/io/unicode_text.h"

#include <utf8proc.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

namespace tactooth {
namespace {

const utf8proc_uint8_t* bytesIn(std::string_view text) {
    return reinterpret_cast<const utf8proc_uint8_t*>(text.data());
}

struct Free {
    void operator()(utf8proc_uint8_t* text) const { std::free(text); }  // as utf8proc_map asks for
};

}  // namespace

std::string validUtf8(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        utf8proc_int32_t letter = 0;
        const utf8proc_ssize_t count =
            utf8proc_iterate(bytesIn(text), static_cast<utf8proc_ssize_t>(text.size()), &letter);
        result += count > 0 ? text.substr(0, static_cast<std::size_t>(count)) : "\xEF\xBF\xBD";
        text.remove_prefix(static_cast<std::size_t>(std::max<utf8proc_ssize_t>(count, 1)));
    }
    return result;
}

std::string composed(std::string_view text) {
    const bool isAscii =
        std::ranges::all_of(text, [](char letter) { return static_cast<unsigned char>(letter) < 0x80; });
    if (isAscii) return std::string(text);
    utf8proc_uint8_t* found = nullptr;
    const utf8proc_ssize_t size = utf8proc_map(bytesIn(text), static_cast<utf8proc_ssize_t>(text.size()), &found,
                                               static_cast<utf8proc_option_t>(UTF8PROC_STABLE | UTF8PROC_COMPOSE));
    const std::unique_ptr<utf8proc_uint8_t, Free> owner(found);
    if (size < 0) return std::string(text);
    return {reinterpret_cast<const char*>(found), static_cast<std::size_t>(size)};
}

}  // namespace tactooth
