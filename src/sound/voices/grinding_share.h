// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

namespace tactooth {

/// How far a bur grinds rather than glides, 0..1. A bur at rest, or nearly so, does not cut.
[[nodiscard]] inline double grindingShare(double speedRpm) {
    constexpr double kGrindingRpm = 500.0;
    return std::min(1.0, speedRpm / kGrindingRpm);
}

}  // namespace tactooth
