// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace tactooth {

struct SessionVerifyOptions {
    std::filesystem::path session;
    std::string key;  ///< that must have signed it, as 64 hexadecimal digits; empty: any, or none
    bool json = false;
};
/// Checks the seal of a recording, if it has one, and then simulates it again and compares. Returns an ExitCode:
/// negative if a byte was changed, the end of a sealed recording is missing, another key has signed it, or the replay
/// differs.
[[nodiscard]] int runSessionVerify(const SessionVerifyOptions& options);

}  // namespace tactooth
