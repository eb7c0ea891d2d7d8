// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tactooth {

struct CutOptions {
    std::filesystem::path tooth;
    std::vector<std::string> layers;  ///< NAME=FILE
    std::string material;             ///< of a tooth without layers; empty: enamel
    std::filesystem::path materials;  ///< TOML; empty: the built-in table
    std::filesystem::path tool;       ///< surface or description; empty: the bur of the case
    std::string workOn;               ///< tooth of a case; empty: the first
    std::filesystem::path trajectory;
    double speedRpm = 0;
    /// mm: walls are exact to a micrometre, and hours of cutting still fit into 600 MB.
    static constexpr double kUsualVoxel = 0.025;
    std::optional<double> voxel;  ///< mm; none: the usual one, or that of the saved tooth
    std::string feed = "law";     ///< or "rigid"
    std::filesystem::path out;
    std::filesystem::path forces;     ///< empty: not written
    std::filesystem::path removed;    ///< empty: not written
    std::filesystem::path events;     ///< empty: not written
    std::filesystem::path save;       ///< empty: not saved
    std::filesystem::path layersOut;  ///< a folder; empty: not written
    std::filesystem::path vdb;        ///< empty: not written
    std::filesystem::path record;     ///< empty: not recorded
    bool seal = false;                ///< signs the recording with the key of this station
};

/// Cuts a tooth with a spinning bur along a trajectory.
[[nodiscard]] int runCut(const CutOptions& options);

}  // namespace tactooth
