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
    ScalarField shown;  ///< as it is drawn: it touches the teeth, so that its margin is where it meets the enamel
    /// What a point of its surface belongs to: 0 the free margin, 1 keratinised gingiva, 2 alveolar mucosa; between
    /// them where one passes into the other.
    ScalarField zone;
    Box3 bounds;
    double smoothBelow = 0;  ///< height toward the crowns below which there is no fine detail
};

/// `missing`: FDI numbers of teeth that are missing; the gingiva has healed there.
[[nodiscard]] GingivaBody gingivaBody(const ToothArrangement& places, bool upper, const std::vector<int>& missing);

}  // namespace tactooth
