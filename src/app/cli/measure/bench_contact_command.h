// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

namespace tactooth {

struct BenchContactOptions {
    std::filesystem::path tooth;   ///< empty: the standard teeth
    std::filesystem::path tool;    ///< empty: the standard bur
    std::vector<int> resolutions;  ///< percent of the triangles; empty: all of the ladder
    int repeat = 3;
    int freedom = 3;  ///< degrees of freedom of the body: 3 or 6
    bool json = false;
};

/// What a tick of contact costs on the standard paths.
[[nodiscard]] int runBenchContact(const BenchContactOptions& options);

}  // namespace tactooth
