// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace tactooth {

// The manual in forms other than --help. All of them read the options that the commands have declared, so each option,
// range and default is written down only once.

/// The man page tactooth(1), in the man macros of troff. `version`: of the program.
[[nodiscard]] std::string manPage(const CLI::App& program, const std::string& version);

/// A completion script for bash: commands, options, choices, and files for the rest.
[[nodiscard]] std::string bashCompletion(const CLI::App& program);

/// The page docs/user/commands.md.
[[nodiscard]] std::string commandsPage(const CLI::App& program);

}  // namespace tactooth
