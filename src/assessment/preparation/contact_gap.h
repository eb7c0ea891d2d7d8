// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "assessment/preparation/measured.h"
#include "assessment/preparation/preparation.h"

namespace tactooth {

/// How far a proximal box opens the contact: the smallest distance, mm, from each of its margins on the outside of the
/// tooth to the uncut tooth beside it. 0 where the ideal preparation has a box and the student's work ends before the
/// outside. Of two boxes the smaller gap.
struct ContactGap {
    Measured gingival, buccal, lingual;
};

[[nodiscard]] ContactGap contactGap(const Preparation& preparation, const CutSurfaces& surfaces);

}  // namespace tactooth
