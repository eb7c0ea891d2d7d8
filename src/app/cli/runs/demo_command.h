// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tactooth {

struct DemoOptions {
    std::filesystem::path out;
    double seconds = 14;              ///< of the session
    std::filesystem::path tooth;      ///< empty: the built-in lower first molar
    std::vector<std::string> layers;  ///< NAME=FILE, inside `tooth`
    std::string workOn;               ///< tooth of a case; empty: the first
    std::filesystem::path materials;  ///< TOML; empty: the built-in table
    bool mouth = false;               ///< the built-in tooth in its mouth
    std::filesystem::path record;     ///< recorded also to this file; empty: only to `out`
    bool seal = false;                ///< signs the recording with the key of this station
    std::filesystem::path bur;        ///< as findOrReadBur finds it; empty: that of the case, or fissure bur 57
};

/// Plays the demonstration session without display, device or sound card. Writes its pictures, sound, plot, table, cut
/// tooth and summary into a folder.
[[nodiscard]] int runDemo(const DemoOptions& options);

}  // namespace tactooth
