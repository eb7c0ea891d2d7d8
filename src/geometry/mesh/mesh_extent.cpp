// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/mesh_extent.h"

#include <algorithm>

#include "geometry/util/number_text.h"

namespace tactooth {

Expected<void> checkExtent(const TriangleMesh& mesh, const std::string& what) {
    float farthest = 0;
    for (const Vec3f& vertex : mesh.vertices) farthest = std::max(farthest, vertex.cwiseAbs().maxCoeff());
    if (static_cast<double>(farthest) <= kMaxCoordinate) return {};
    return unexpected(what + " reaches " + numberText(static_cast<double>(farthest)) +
                      " mm from its origin, farther than anything can be felt or cut (1 km): look for a stray corner, "
                      "or check the unit");
}

}  // namespace tactooth
