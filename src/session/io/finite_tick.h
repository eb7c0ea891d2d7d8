// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/proxy/contact_query.h"
#include "geometry/util/expected.h"
#include "haptics/haptic_simulation.h"

namespace tactooth {

/// Checks that all numbers that a run writes of a tick are finite. Otherwise the run must end without a result; the
/// error names the time and the quantity. `time`: of the trajectory, s.
[[nodiscard]] Expected<void> checkFinite(double time, const Tick& tick);
[[nodiscard]] Expected<void> checkFinite(double time, const Contact& contact);

}  // namespace tactooth
