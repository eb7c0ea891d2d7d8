// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "assessment/preparation/measured.h"
#include "assessment/preparation/prepared_volumes.h"

namespace tactooth {

/// What was removed of each tissue, and what was spared, mm^3. None of it is known of a tooth without layers.
struct TissueVolumes {
    Measured removedEnamel, removedDentin, removedPulp, removedDecay;
    Measured decayLeft;                 ///< in the whole tooth
    Measured decayShare;                ///< removed share of all decay, 0..1
    Measured overEnamel, overDentin;    ///< removed, but not to be removed
    Measured underEnamel, underDentin;  ///< to be removed, but still there
};

/// `volumes`: of preparedVolumes over both cut surfaces. `spacing`: of the lines through the decay, mm.
[[nodiscard]] TissueVolumes tissueVolumes(const Preparation& preparation, const PreparedVolumes& volumes,
                                          double spacing);

}  // namespace tactooth
