// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

namespace tactooth {

struct SessionTrimOptions {
    std::filesystem::path session;
    double from = 0;           ///< s
    std::optional<double> to;  ///< s; nothing: the end
    std::filesystem::path out;
};
/// Writes a part of a recording that can be replayed.
[[nodiscard]] int runSessionTrim(const SessionTrimOptions& options);

}  // namespace tactooth
