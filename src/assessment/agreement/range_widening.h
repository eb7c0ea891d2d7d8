// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "assessment/rubric/rubric.h"

namespace tactooth {

/// `levels` with ranges that are `factor` times as wide (over 0). Each side moves away from a fixed point: the middle
/// of the ideal range, or its other end where that side has no limit, but no farther inside the ideal range than the
/// score takes to fall from 100 to 0. A side without a limit stays without. Ends are rounded to 0.0001 where they stay
/// in order.
[[nodiscard]] LevelRanges widened(const LevelRanges& levels, double factor);

}  // namespace tactooth
