// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace tactooth {

struct FeelOptions {
    std::filesystem::path tooth;
    std::filesystem::path tool;
    std::filesystem::path trajectory;
    std::filesystem::path out;
    std::string mode = "proxy";       ///< or "penalty"
    int freedom = 3;                  ///< degrees of freedom of the proxy: 3 or 6
    std::optional<double> stiffness;  ///< N/mm
    std::optional<double> damping;    ///< N*s/mm
    double friction = 0;              ///< Coulomb coefficient
    std::filesystem::path materials;  ///< TOML; empty: the built-in table
    std::filesystem::path record;     ///< empty: not recorded
    bool seal = false;                ///< signs the recording with the key of this station
    std::string workOn;               ///< tooth of a case; empty: the first
};

/// Runs one haptic simulation of a tool along a trajectory.
[[nodiscard]] int runFeel(const FeelOptions& options);

}  // namespace tactooth
