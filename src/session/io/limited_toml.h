// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <toml++/toml.h>

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "geometry/util/expected.h"

namespace tactooth {

/// The most that a TOML file may hold. A parser calls itself for each bracket, and what it made is taken down by calls
/// as deep as its keys have parts: without limits a file of 100 kB ends the program.
struct TomlLimits {
    std::size_t bytes = std::size_t{1} << 20;
    std::size_t lineBytes = std::size_t{1} << 16;  ///< where the window keeps its docks it takes some thousand
    int nesting = 32;                              ///< brackets and braces within each other
    int keyParts = 16;                             ///< of a.key.with.dots
    std::size_t values = 50'000;
};
inline constexpr TomlLimits kTomlLimits = {};

/// Parses a text that anybody may have written; the one way in which the program takes TOML. `name` stands for the
/// file in messages. Fails with one sentence with file and line: more of anything than kTomlLimits allows, or not TOML.
[[nodiscard]] Expected<toml::table> parseToml(std::string_view text, std::string_view name);

/// The same from a file.
[[nodiscard]] Expected<toml::table> readToml(const std::filesystem::path& file);

}  // namespace tactooth
