// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace tactooth {

struct SessionInfoOptions {
    std::filesystem::path session;
    bool json = false;
};
/// Prints what a recording holds.
[[nodiscard]] int runSessionInfo(const SessionInfoOptions& options);

struct SessionRepairOptions {
    std::filesystem::path session;
    std::filesystem::path out;
};
/// Writes the whole blocks of a recording that was cut off as a recording that ends there.
[[nodiscard]] int runSessionRepair(const SessionRepairOptions& options);

}  // namespace tactooth
