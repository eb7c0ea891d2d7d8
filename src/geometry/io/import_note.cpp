// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/io/import_note.h"

#include <array>
#include <charconv>

namespace tactooth {

std::string inWords(const ImportNote& importNote) { return importNote.message.in(Language::English); }

std::string rounded(double value, int digits) {
    std::array<char, 400> text;  // the largest double has 309 digits before the point
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, digits);
    return {text.data(), end.ptr};
}

}  // namespace tactooth
