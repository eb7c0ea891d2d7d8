// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace tactooth {

struct BenchStabilityOptions {
    std::vector<std::string> devices;  ///< names; empty: all
    std::vector<std::string> hands;
    std::vector<std::string> materials;  ///< "stiffest" is one of them
    std::vector<std::string> situations;
    double rateHz = 1000;
    bool all = false;  ///< every run, not only a line for each device and hand
    bool json = false;
};

/// Closes the loop with simulated devices and hands and says which runs stayed stable: an ExitCode, negative if one
/// did not.
[[nodiscard]] int runBenchStability(const BenchStabilityOptions& options);

}  // namespace tactooth
