// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace tactooth {

struct ScoreOptions {
    std::filesystem::path tooth;   ///< saved, with the record of the removed material
    std::filesystem::path target;  ///< ideal shape, or another saved tooth
    bool json = false;
};

int runScore(const ScoreOptions& options);

}  // namespace tactooth
