// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <toml++/toml.h>

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "geometry/util/expected.h"

namespace tactooth {

/// Limits of a TOML file. The parser recurses for each bracket, and the destructor of its result recurses for each part
/// of a key. Without limits a file of 100 kB overflows the stack.
struct TomlLimits {
    std::size_t bytes = std::size_t{1} << 20;
    std::size_t lineBytes = std::size_t{1} << 16;  ///< the window's dock state takes a few thousand
    int nesting = 32;                              ///< brackets and braces within each other
    int keyParts = 16;                             ///< of a dotted key
    std::size_t values = 50'000;
};
inline constexpr TomlLimits kTomlLimits = {};

/// Parses an untrusted text; all TOML of the program comes in here. `name` stands for the file in messages. Fails with
/// one sentence with file and line if the text is no TOML or exceeds kTomlLimits.
[[nodiscard]] Expected<toml::table> parseToml(std::string_view text, std::string_view name);

/// The same from a file.
[[nodiscard]] Expected<toml::table> readToml(const std::filesystem::path& file);

}  // namespace tactooth
