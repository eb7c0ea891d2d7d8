// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// The floor of a cavity: places that are spread evenly over it as one sees it along `axis` (unit, out of the
/// preparation), 0.05 mm apart, mm. `cut`: the surface that cutting has made. Empty where nothing faces the axis.
///
/// The floor faces the axis within 30 degrees; where too little does, within 45. Low ridges and narrow grooves in it,
/// as a bur leaves them between its passes, belong to it however steep they are. A strip along its border, with the
/// round angles to the walls, does not: 0.3 mm, or in a narrow floor half as far as its middle is from the border. Of
/// several floors it is the largest.
[[nodiscard]] std::vector<Vec3> floorPlaces(const TriangleMesh& cut, const Vec3& axis);

}  // namespace tactooth
