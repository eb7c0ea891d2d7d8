// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace tactooth {

struct BenchStabilityOptions {
    std::vector<std::string> devices;  ///< names; empty: all
    std::vector<std::string> hands;
    std::vector<std::string> materials;  ///< "stiffest" is a valid name
    std::vector<std::string> situations;
    double rateHz = 1000;
    bool all = false;  ///< prints every run, not only one line for each device and hand
    bool json = false;
};

/// Closes the loop with simulated devices and hands and prints which runs stayed stable. Returns an ExitCode: negative
/// if one run did not.
[[nodiscard]] int runBenchStability(const BenchStabilityOptions& options);

}  // namespace tactooth
