// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <filesystem>
#include <functional>

namespace tactooth {

/// The value of an environment variable, null if it is not set.
using VariableLookup = std::function<const char*(const char* name)>;

/// Whether there is anything that OpenAL could play on: a sound card, a sound server, or a choice that the user has
/// made by himself. OpenAL Soft looks for sound servers once in the life of a process; asked before there is one, it
/// never finds it. `root`: where the system's folders begin.
[[nodiscard]] bool hasSoundSystem(
    const std::filesystem::path& root = "/",
    const VariableLookup& variable = [](const char* name) { return std::getenv(name); });

}  // namespace tactooth
