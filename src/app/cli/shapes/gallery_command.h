// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace tactooth {

struct GalleryOptions {
    std::filesystem::path out;
    int triangles = 20000;   ///< per tooth
    std::uint32_t seed = 0;  ///< of the teeth
    std::vector<int> teeth;  ///< FDI numbers, each on a page of its own; empty: all on one sheet
    bool exercises = false;  ///< the ideal of each built-in exercise, in place of the sheets
    bool noCache = false;    ///< makes all teeth again, and does not store them
};

/// Draws the built-in teeth and instruments as contact sheets: teeth.png and instruments.png; or a picture of the ideal
/// of each built-in exercise: ID.jpg.
[[nodiscard]] int runGallery(const GalleryOptions& options);

}  // namespace tactooth
