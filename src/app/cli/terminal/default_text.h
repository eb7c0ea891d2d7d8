// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace tactooth {

/// Help of an option with its default, which stands in the options alone: "Length of the session, s (default: 14)".
/// `meaning`: what the default says, as ", average teeth".
template <class Value>
[[nodiscard]] std::string withDefault(std::string_view help, const Value& value, std::string_view meaning = {}) {
    return fmt::format("{} (default: {}{})", help, value, meaning);
}

}  // namespace tactooth
