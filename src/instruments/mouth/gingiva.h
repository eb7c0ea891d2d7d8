// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/field/isosurface.h"
#include "instruments/mouth/tooth_arrangement.h"

namespace tactooth {

/// The soft tissue of one jaw and the ridge below it, as a body with a socket for each tooth; in the upper jaw with the
/// palate. Mouth frame, mouth closed.
struct GingivaBody {
    ScalarField field;
    Box3 bounds;
    double smoothBelow = 0;  ///< height toward the crowns below which there is no fine detail
};

/// `missing`: FDI numbers of teeth that are missing; the gingiva has healed there.
[[nodiscard]] GingivaBody gingivaBody(const ToothArrangement& places, bool upper, const std::vector<int>& missing);

}  // namespace tactooth
