// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace tactooth {

struct SimplifyOptions {
    std::filesystem::path in;
    std::filesystem::path out;
    std::string keep;  ///< "50%" of the triangles, or a number of triangles
};

/// Writes a surface with fewer triangles, as close to the original as they allow.
[[nodiscard]] int runSimplify(const SimplifyOptions& options);

}  // namespace tactooth
