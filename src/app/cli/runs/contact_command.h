// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace tactooth {

struct ContactOptions {
    std::filesystem::path tooth;
    std::filesystem::path tool;
    std::filesystem::path poses;
    std::filesystem::path out;
};

/// Computes the penetration depth of a tool in a tooth at every pose of a file, each pose independently.
[[nodiscard]] int runContact(const ContactOptions& options);

}  // namespace tactooth
