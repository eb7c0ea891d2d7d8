// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <filesystem>
#include <functional>

namespace tactooth {

/// The value of an environment variable, null if it is not set.
using VariableLookup = std::function<const char*(const char* name)>;

/// Whether OpenAL could play on anything: a sound card, a sound server, or a setting of the user. OpenAL Soft searches
/// for sound servers once in the life of a process; asked before there is one, it never finds it. `root`: where the
/// system's folders begin.
[[nodiscard]] bool hasSoundSystem(
    const std::filesystem::path& root = "/",
    const VariableLookup& variable = [](const char* name) { return std::getenv(name); });

}  // namespace tactooth
