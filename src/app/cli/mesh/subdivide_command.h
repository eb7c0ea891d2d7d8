// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

namespace tactooth {

/// Either `triangles` or `times`; neither means once.
struct SubdivideOptions {
    std::filesystem::path in;
    std::filesystem::path out;
    std::optional<std::size_t> triangles;
    std::optional<int> times;
};

/// Writes the same surface with more triangles.
[[nodiscard]] int runSubdivide(const SubdivideOptions& options);

}  // namespace tactooth
