// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "instruments/anatomy/tooth_shape.h"
#include "instruments/builtin_tooth.h"

namespace tactooth {

/// A place in the surface of a tooth where decay or a filling begins, and the direction into the tooth.
struct LesionOrigin {
    Vec3 site, inward;
    double enamel = 1;  ///< thickness of the enamel there, mm
};
[[nodiscard]] LesionOrigin lesionOrigin(const ToothShape& shape, LesionSite site);

/// A caries lesion as a body: narrow through the enamel, then wider along the border of the dentin and toward the pulp,
/// like fissure and contact lesions. It protrudes from the tooth; intersect it with the tooth. The width is 0..4 mm,
/// the depth positive.
/// All places where a lesion begins give one body, with fillets between them.
[[nodiscard]] ScalarField lesionBody(const ToothShape& shape, const Lesion& lesion);

/// A lesion together with its rim: all dentin in the lesion, or nearer to it than the width of the rim. `lesion` has a
/// rim.
[[nodiscard]] ScalarField lesionRimBody(const ToothShape& shape, const Lesion& lesion);

}  // namespace tactooth
