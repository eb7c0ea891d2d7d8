// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace tactooth {

struct BenchViewOptions {
    std::filesystem::path tooth;  ///< empty: the standard tooth of 325,312 triangles
    std::string size = "1280x800";
    int frames = 60;
    bool mouth = false;  ///< only the mouth
    bool json = false;
};

/// Measures the cost of frames on this machine.
[[nodiscard]] int runBenchView(const BenchViewOptions& options);

}  // namespace tactooth
