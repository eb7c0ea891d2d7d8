// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/core.h>

#include <cstdio>
#include <string_view>
#include <utility>

namespace tactooth {

/// Writes to a stream. If the stream is closed or full, the error is kept for outputError and the work goes on.
/// fmt::print would throw an exception here.
void writeTo(std::FILE* stream, std::string_view text);

/// The reason why output to stdout failed: an errno, -1 if it is unknown, 0 if nothing failed.
[[nodiscard]] int outputError();

/// Formats as fmt::print does.
template <class... Values>
void print(std::FILE* stream, fmt::format_string<Values...> text, Values&&... values) {
    writeTo(stream, fmt::format(text, std::forward<Values>(values)...));
}
template <class... Values>
void print(fmt::format_string<Values...> text, Values&&... values) {
    writeTo(stdout, fmt::format(text, std::forward<Values>(values)...));
}

}  // namespace tactooth
