// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "geometry/field/isosurface.h"

namespace tactooth {

/// A tooth as implicit functions, which the mesher turns into layers. Frame: that of a BuiltinTooth, but with +x mesial
/// for every tooth. Teeth of the patient's upper left and lower right quadrant are mirrored when they are meshed.
struct ToothShape {
    std::string name;
    int fdi = 0;
    Box3 bounds;
    ScalarField outer;     ///< the whole tooth
    ScalarField core;      ///< the dentin core of the crown, before it is cut by `outer`; equal to `outer` at the root
    ScalarField cervical;  ///< height above the cervical line: positive in the crown
    ScalarField pulp;
    Vec3 lesionSite;          ///< on the surface
    Vec3 lesionInward;        ///< unit, direction in which a lesion grows
    double lesionEnamel = 1;  ///< thickness of the enamel there, mm
};

/// The shape of a permanent tooth (FDI 11-18, 21-28, 31-38, 41-48): that of the right side, with its own number. Seed 0
/// is the average tooth, any other one the same tooth of another patient.
[[nodiscard]] ToothShape toothShape(int fdi, std::uint32_t seed = 0);

}  // namespace tactooth
