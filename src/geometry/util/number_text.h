// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace tactooth {

/// Reads all of `word` as a number, with '.' as decimal point whatever the locale; nothing if it is not a number. A
/// number too small for the type becomes zero, one too large infinity. "nan" and "inf" are numbers here; the caller has
/// to refuse them.
template <class Number>
[[nodiscard]] std::optional<Number> toNumber(std::string_view word) {
    if (word.size() > 1 && word[0] == '+' && word[1] != '-')
        word.remove_prefix(1);  // std::from_chars accepts no plus sign
    const char* end = word.data() + word.size();
    Number value = 0;
    const auto [stop, failure] = std::from_chars(word.data(), end, value);
    if (stop != end || failure == std::errc::invalid_argument) return std::nullopt;
    if (failure == std::errc::result_out_of_range) {
        const bool tiny = word.find("e-") != word.npos || word.find("E-") != word.npos;
        return tiny ? Number{0} : std::numeric_limits<Number>::infinity();
    }
    return value;
}

/// The shortest text that toNumber reads as the same double, whatever the locale.
[[nodiscard]] std::string numberText(double value);

/// A word of an untrusted file in a form for a message: in quotes, at most 24 characters, through displayText.
[[nodiscard]] std::string quotedWord(std::string_view word);

}  // namespace tactooth
