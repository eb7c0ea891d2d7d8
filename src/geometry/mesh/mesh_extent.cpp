// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/mesh_extent.h"

#include <algorithm>

#include "geometry/util/messages.h"
#include "geometry/util/number_text.h"

namespace tactooth {

Expected<void> checkExtent(const TriangleMesh& mesh, const Message& what) {
    float farthest = 0;
    for (const Vec3f& vertex : mesh.vertices) farthest = std::max(farthest, vertex.cwiseAbs().maxCoeff());
    if (static_cast<double>(farthest) <= kMaxCoordinate) return {};
    return unexpected(msg::kReachesTooFar, what, numberText(static_cast<double>(farthest)));
}

}  // namespace tactooth
