// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/modelling/fold_check.h"

#include <span>

#include "geometry/mesh/mesh_edges.h"

namespace tactooth {

bool hasFolds(const TriangleMesh& mesh, double sharpest) {
    bool folded = false;
    MeshEdges(mesh).forEachEdge([&](std::span<const EdgeUse> uses) {
        if (uses.size() != 2) return;
        const Vec3 a = mesh.areaVector(uses[0].corner / 3), b = mesh.areaVector(uses[1].corner / 3);
        folded |= a.dot(b) < sharpest * a.norm() * b.norm();
    });
    return folded;
}

}  // namespace tactooth
