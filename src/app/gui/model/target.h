// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <memory>

#include "assessment/cavity_ghost.h"
#include "assessment/cavity_metrics.h"
#include "collision/solid/distance_grid.h"

namespace tactooth {

/// The target shape that a tooth is compared with.
struct Target {
    QString name;
    std::shared_ptr<const DistanceGrid> distances;
    std::shared_ptr<const DistanceGrid> guideWalls;  ///< see WallGuide
    std::shared_ptr<CavityGhost> ghost;
    std::shared_ptr<CavityMetrics> metrics;
};

/// Is called with the share of the work that is done, 0..1.
using TargetProgress = std::function<void(double share)>;

/// `ideal`: closed, tooth frame; `outer`: surface of the uncut tooth, which lies in `box`. Takes some seconds for a
/// large tooth.
[[nodiscard]] Target makeTarget(const QString& name, TriangleMesh ideal, const SurfacePart& outer, const Box3& box,
                                const TargetProgress& progress = {});

}  // namespace tactooth
