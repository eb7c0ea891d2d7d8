// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

namespace tactooth {

struct BenchContactOptions {
    std::filesystem::path tooth;   ///< empty: the standard teeth
    std::filesystem::path tool;    ///< empty: the standard bur
    std::vector<int> resolutions;  ///< percent of the triangles; empty: the whole ladder
    int repeat = 3;
    int freedom = 3;  ///< of the proxy, in degrees of freedom: 3 or 6
    bool json = false;
};

/// Measures the cost of a tick with contact on the standard paths.
[[nodiscard]] int runBenchContact(const BenchContactOptions& options);

}  // namespace tactooth
