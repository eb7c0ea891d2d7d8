// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/preparation/forbidden_volume.h"

#include <optional>

#include "assessment/messages.h"
#include "assessment/outline/flat_outline.h"
#include "assessment/preparation/prepared_volumes.h"
#include "collision/bvh/closest_point.h"

namespace tactooth {

Measured forbiddenVolume(const Preparation& preparation, const CutSurfaces& surfaces, double spacing) {
    if (preparation.forbidden.empty()) return Measured::none(msg::kNoForbiddenZone);
    double sum = 0, deepest = 0;
    std::optional<Vec3> place;  // of the deepest cut in a zone
    for (const ForbiddenZone& zone : preparation.forbidden) {
        const FlatOutline outline(zone.corners, zone.outward);
        ColumnGrid columns(zone.outward, surfaces.cut.mesh, surfaces.cut.mesh, spacing);
        columns.keep([&](const Vec3& at) { return outline.contains(outline.flat(at)); });
        const PreparedVolumes volumes = preparedVolumes(preparation, columns);
        sum += volumes.common + volumes.over;
        for (const Facet& facet : surfaces.facets) {
            if (!outline.contains(outline.flat(facet.centre))) continue;
            const double depth = -signedDistance(*preparation.original, facet.centre);
            if (depth <= deepest) continue;
            deepest = depth;
            place = facet.centre;
        }
    }
    return sum > 0 && place ? Measured::at(sum, *place) : Measured::of(sum);
}

}  // namespace tactooth
