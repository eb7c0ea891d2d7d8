// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace tactooth {

struct SoundOptions {
    std::filesystem::path profile;
    std::filesystem::path materials;  ///< TOML; empty: the program's own
    std::filesystem::path out;
    std::filesystem::path spectrogram;  ///< empty: not written
    std::filesystem::path sounds;       ///< preset or recording; empty: everything is synthesised
    std::string drive = "turbine";      ///< or "electric", "low-speed"
    int blades = 0;                     ///< of the bur; 0: a diamond
    bool headphones = false;
    bool room = false;
    bool water = false;
    bool suction = false;
};

/// Renders the sound of a bur. A file gives its speed, removal power and material over time.
[[nodiscard]] int runSound(const SoundOptions& options);

}  // namespace tactooth
