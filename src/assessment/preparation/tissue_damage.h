// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "assessment/preparation/measured.h"
#include "assessment/preparation/preparation.h"

namespace tactooth {

/// What a preparation must spare.
struct TissueDamage {
    Measured remainingDentin;  ///< smallest distance from the cut to the pulp, mm; 0 where it opens it
    Measured pulpOpen;         ///< 1: the cut opens the pulp, 0: it does not
    Measured neighbourDepth;   ///< greatest depth of a cut in a neighbour, mm
    /// Connected cuts in the neighbours: those deeper than 0.05 mm, and of these the ones deeper than 0.2 mm.
    Measured neighbourScratches, neighbourNicks;
};

[[nodiscard]] TissueDamage tissueDamage(const Preparation& preparation, const CutSurfaces& surfaces);

}  // namespace tactooth
