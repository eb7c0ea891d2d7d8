// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/model/target.h"

#include "session/control/wall_guide.h"

namespace tactooth {

Target makeTarget(const QString& name, TriangleMesh ideal, const SurfacePart& outer, const Box3& box) {
    CavityWalls walls = cavityWalls(ideal, outer);
    auto surface = std::make_shared<const SurfacePart>(std::move(ideal));
    auto metrics = std::make_shared<CavityMetrics>(surface, outer, walls);
    const Box3 cavity = walls.mesh.empty() ? box : boundingBox(walls.mesh);
    auto guide = std::make_shared<const DistanceGrid>(guideWalls(*surface, cavity));
    auto ghost = std::make_shared<CavityGhost>(std::move(walls), outer);
    auto grid = std::make_shared<const DistanceGrid>(sampleDistances(*surface, box));
    return {name, std::move(grid), std::move(guide), std::move(ghost), std::move(metrics)};
}

}  // namespace tactooth
