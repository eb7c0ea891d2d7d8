// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/util/number_text.h"

#include <array>

#include "geometry/util/assert.h"
#include "geometry/util/display_text.h"

namespace tactooth {

std::string numberText(double value) {
    std::array<char, 32> digits;  // the longest double takes 24
    const auto [end, failure] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    TACTOOTH_ASSERT(failure == std::errc{});
    return {digits.data(), end};
}

std::string quotedWord(std::string_view word) {
    constexpr std::size_t kLongest = 24;  // characters
    return "'" + displayShort(word, kLongest) + "'";
}

}  // namespace tactooth
