// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/core.h>

#include <cstdio>
#include <string_view>
#include <utility>

namespace tactooth {

/// Writes to a stream; where it is closed or full this is kept for outputError, and the work goes on. fmt::print would
/// throw there.
void writeTo(std::FILE* stream, std::string_view text);

/// Why something that was written to stdout did not get there: an errno, -1 if that is not known, 0 for nothing.
[[nodiscard]] int outputError();

/// As fmt::print.
template <class... Values>
void print(std::FILE* stream, fmt::format_string<Values...> text, Values&&... values) {
    writeTo(stream, fmt::format(text, std::forward<Values>(values)...));
}
template <class... Values>
void print(fmt::format_string<Values...> text, Values&&... values) {
    writeTo(stdout, fmt::format(text, std::forward<Values>(values)...));
}

}  // namespace tactooth
