// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/vec.h"

namespace tactooth {

inline constexpr double kFastestHand =
    5000;                                   ///< mm/s: three times the quickest of hands; more is a jump of the reading
inline constexpr double kSmallestJump = 5;  ///< mm: less is no jump, however short the tick

/// Whether no hand can have moved by `way` mm within `elapsed` s. True also for what is no number.
[[nodiscard]] inline bool isHandJump(const Vec3& way, double elapsed) {
    return !(way.norm() < kSmallestJump + kFastestHand * elapsed);
}

}  // namespace tactooth
