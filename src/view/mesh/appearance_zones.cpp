// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/mesh/appearance_zones.h"

#include "geometry/util/parallel_for.h"

namespace tactooth {

AppearanceMix zonedMix(const AppearanceZones& zones, const AppearanceMix& mix, AppearanceZones::Place at) {
    at.tag = mix.first;
    const AppearanceMix first = zones.at(at);
    if (mix.share == 0 || mix.first == mix.second) return first;
    at.tag = mix.second;
    const AppearanceMix second = zones.at(at);
    const auto strongest = [](const AppearanceMix& of) { return of.share > 127 ? of.second : of.first; };
    return {strongest(first), strongest(second), mix.share};
}

void applyZones(const AppearanceZones& zones, const TriangleMesh& mesh, CornerShading& shading) {
    parallelFor(mesh.triangles.size(), [&](std::size_t t) {
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t vertex = mesh.triangles[t][c];
            AppearanceMix& mix = shading.appearances[3 * t + c];
            mix = zonedMix(zones, mix, {.point = mesh.vertices[vertex].cast<double>(), .vertex = vertex});
        }
    });
}

}  // namespace tactooth
