// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "assessment/gauge/column_grid.h"
#include "assessment/preparation/measured.h"
#include "assessment/preparation/preparation.h"

namespace tactooth {

/// How far the prepared surface lies from the ideal one.
struct SurfaceDeviation {
    Measured overMax;                ///< greatest depth beyond the ideal surface, mm
    Measured rms;                    ///< mm
    Measured mean;                   ///< signed, mm; positive: too little was removed
    Measured median, p95;            ///< of the absolute distance: not exceeded on half and on 95 % of the area, mm
    std::array<Measured, 4> within;  ///< share of the area within 0.1, 0.2, 0.3, 0.4 mm of the ideal surface, 0..1
};

/// By area, not by vertices: where the student has cut, and where the ideal preparation is not reached. `columns`
/// cover both cut surfaces.
[[nodiscard]] SurfaceDeviation surfaceDeviation(const Preparation& preparation, const ColumnGrid& columns);

}  // namespace tactooth
