// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace tactooth {

struct RealtimeOptions {
    double seconds = 20;
    double rateHz = 1000;
    bool load = false;  ///< keep all other cores busy during the run
    bool json = false;
    std::filesystem::path record;  ///< recorded session to write; empty: none
    bool seal = false;             ///< signs the recording with the key of this station
    std::string stream;            ///< address of a live stream (StreamAddress::parse); empty: none
};

/// Lets a simulated hand touch and cut the built-in molar in real time. Prints the timing of this machine. Returns an
/// ExitCode: negative if the force was not computed in time.
[[nodiscard]] int runRealtime(const RealtimeOptions& options);

}  // namespace tactooth
