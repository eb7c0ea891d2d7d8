// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/model/target.h"

namespace tactooth {

Target makeTarget(const QString& name, TriangleMesh ideal, const SurfacePart& outer, const Box3& box) {
    CavityWalls walls = cavityWalls(ideal, outer);
    auto surface = std::make_shared<const SurfacePart>(std::move(ideal));
    auto metrics = std::make_shared<CavityMetrics>(surface, outer, walls);
    auto ghost = std::make_shared<CavityGhost>(std::move(walls), outer);
    auto grid = std::make_shared<const DistanceGrid>(sampleDistances(*surface, box));
    return {name, std::move(grid), std::move(ghost), std::move(metrics)};
}

}  // namespace tactooth
