// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

namespace tactooth {

struct BenchCutOptions {
    std::filesystem::path tooth;    ///< empty: the standard tooth of 325,312 triangles
    std::vector<double> voxels;     ///< um; empty: 100, 50, 25 and 15
    std::vector<double> diameters;  ///< of the round burs, mm; empty: 0.5 to 2.3
    int cores = 1;                  ///< available to the carving thread
    bool json = false;
};

/// Measures the cost of cutting on the standard paths.
[[nodiscard]] int runBenchCut(const BenchCutOptions& options);

}  // namespace tactooth
