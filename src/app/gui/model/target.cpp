// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/model/target.h"

#include "session/control/wall_guide.h"

namespace tactooth {

Target makeTarget(const QString& name, TriangleMesh ideal, const SurfacePart& outer, const Box3& box,
                  const TargetProgress& progress) {
    const auto report = [&](double share) {
        if (progress) progress(share);
    };
    // About these shares of the time; the ideal shape was made before.
    constexpr double kIdeal = 0.2, kWalls = 0.3, kMetrics = 0.5, kGuide = 0.6, kGhost = 0.7;
    report(kIdeal);
    CavityWalls walls = cavityWalls(ideal, outer);
    report(kWalls);
    auto surface = std::make_shared<const SurfacePart>(std::move(ideal));
    auto metrics = std::make_shared<CavityMetrics>(surface, outer, walls);
    report(kMetrics);
    const Box3 cavity = walls.mesh.empty() ? box : boundingBox(walls.mesh);
    auto guide = std::make_shared<const DistanceGrid>(guideWalls(*surface, cavity));
    report(kGuide);
    auto ghost = std::make_shared<CavityGhost>(std::move(walls), outer);
    report(kGhost);
    auto grid = std::make_shared<const DistanceGrid>(sampleDistances(*surface, box));
    report(1);
    return {name, std::move(grid), std::move(guide), std::move(ghost), std::move(metrics)};
}

}  // namespace tactooth
