// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "assessment/preparation/measured.h"
#include "assessment/preparation/preparation.h"

namespace tactooth {

/// How large a preparation is, and what it leaves beside it.
struct CavityExtent {
    /// Length of the cut surface along x, y and z of the tooth's frame, mm.
    Measured mesiodistal, buccolingual, vertical;
    /// Of a cavity from the occlusal side: its smallest width across its longest direction, mm, without its two ends,
    /// each half as long as it is wide.
    Measured isthmus;
    /// The same: smallest distance from it to the mesial and the distal outside of the tooth, mm.
    Measured mesialRidge, distalRidge;
};

[[nodiscard]] CavityExtent cavityExtent(const Preparation& preparation, const CutSurfaces& surfaces);

}  // namespace tactooth
