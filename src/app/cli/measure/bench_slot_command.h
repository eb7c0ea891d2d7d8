// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace tactooth {

struct BenchSlotOptions {
    std::filesystem::path tooth;  ///< empty: the standard tooth of 325,312 triangles
    double voxel = 25;            ///< um
    bool json = false;
};

/// Measures the cost of contact on all sides of a slot, and the stability of that contact.
[[nodiscard]] int runBenchSlot(const BenchSlotOptions& options);

}  // namespace tactooth
