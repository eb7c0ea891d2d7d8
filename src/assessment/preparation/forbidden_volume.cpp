// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/preparation/forbidden_volume.h"

#include "assessment/messages.h"
#include "assessment/outline/flat_outline.h"
#include "assessment/preparation/prepared_volumes.h"

namespace tactooth {

Measured forbiddenVolume(const Preparation& preparation, const CutSurfaces& surfaces, double spacing) {
    if (preparation.forbidden.empty()) return Measured::none(msg::kNoForbiddenZone);
    double sum = 0;
    for (const ForbiddenZone& zone : preparation.forbidden) {
        const FlatOutline outline(zone.corners, zone.outward);
        ColumnGrid columns(zone.outward, surfaces.cut.mesh, surfaces.cut.mesh, spacing);
        columns.keep([&](const Vec3& place) { return outline.contains(outline.flat(place)); });
        const PreparedVolumes volumes = preparedVolumes(preparation, columns);
        sum += volumes.common + volumes.over;
    }
    return Measured::of(sum);
}

}  // namespace tactooth
