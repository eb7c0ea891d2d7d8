// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "instruments/builtin_tooth.h"

namespace tactooth {

struct ToothOptions {
    int fdi = 46;
    std::filesystem::path out;
    int triangles = 20000;
    std::uint32_t seed = 0;
    std::string caries;  ///< site; empty: a sound tooth
    double cariesWidth = kDefaultLesionWidth;
    std::optional<double> cariesDepth;
    bool noCache = false;
};

/// Writes a tooth of the built-in mouth as STL layers into a folder.
[[nodiscard]] int runTooth(const ToothOptions& options);

}  // namespace tactooth
