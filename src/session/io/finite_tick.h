// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/proxy/contact_query.h"
#include "geometry/util/expected.h"
#include "haptics/haptic_simulation.h"

namespace tactooth {

/// Whether all that a run writes of a moment is finite. If not, the run has to end without a result: one sentence that
/// says when, and which quantity it was. `time`: as the trajectory counts it, s.
[[nodiscard]] Expected<void> checkFinite(double time, const Tick& tick);
[[nodiscard]] Expected<void> checkFinite(double time, const Contact& contact);

}  // namespace tactooth
