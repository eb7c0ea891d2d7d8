// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/simulation/pulp_opening.h"

#include <algorithm>

namespace tactooth {

std::optional<Vec3> nearestPulp(const Surface& tooth, const MaterialRegistry& materials, const Vec3& tip) {
    constexpr double kFarthest = 6;  // mm: the longest head of a bur, less what its tip has in the dentin
    double nearest2 = kFarthest * kFarthest;
    std::optional<Vec3> place;
    for (const auto& patch : tooth.patches) {
        const TriangleMesh& mesh = patch->mesh();
        if (mesh.empty() || patch->tree().box().squaredExteriorDistance(tip) > nearest2) continue;
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            if (!materials.hasRole(static_cast<MaterialId>(patch->tag(t)), MaterialRole::Pulp)) continue;
            const Vec3 middle = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3;
            const double distance2 = (middle - tip).squaredNorm();
            if (distance2 >= nearest2) continue;
            nearest2 = distance2;
            place = middle;
        }
    }
    return place;
}

void PulpOpening::follow(const CutEvents& events, const Surface& tooth, const MaterialRegistry& materials) {
    const std::vector<CutEvent>& all = events.all();
    const auto newest = std::find_if(all.rbegin(), all.rend(), [](const CutEvent& event) {
        return event.kind == CutEventKind::PulpExposed && !event.isTakenBack;
    });
    if (newest == all.rend()) {
        place_.reset();
        return;
    }
    const std::pair surface(tooth.base->id(), tooth.revision);
    if (place_ && newest->time == time_ && (isOnSurface_ || surface == searched_)) return;
    searched_ = surface;
    const std::optional<Vec3> found = nearestPulp(tooth, materials, newest->place);
    place_ = found.value_or(newest->place);  // the surface comes a little later than the event
    time_ = newest->time;
    isOnSurface_ = found.has_value();
}

}  // namespace tactooth
