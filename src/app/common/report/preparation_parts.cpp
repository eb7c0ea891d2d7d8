// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/report/preparation_parts.h"

#include <cmath>
#include <cstdint>
#include <utility>

namespace tactooth {

void addPulps(Preparation& preparation) {
    for (const LayeredTooth::Layer& layer : preparation.tooth->layers()) {
        if (preparation.tooth->materials().hasRole(layer.material, MaterialRole::Pulp))
            preparation.pulps.push_back(layer.part);
    }
}

void addNeighbours(Preparation& preparation, const LayeredTooth& uncut, const Surface& cut, const Pose& pose) {
    const MaterialRegistry& materials = uncut.materials();
    const auto adjacent = [&](const SurfacePart& part) {
        TriangleMesh mesh{part.mesh().vertices, {}};
        for (std::uint32_t i = part.firstAdjacent(); i < part.mesh().triangles.size(); ++i) {
            const auto material = static_cast<MaterialId>(part.tag(i));
            if (!materials.hasRole(material, MaterialRole::Surroundings))
                mesh.triangles.push_back(part.mesh().triangles[i]);
        }
        return transformed(mesh, pose);
    };
    TriangleMesh neighbours = adjacent(*uncut.outer());
    if (neighbours.empty()) return;
    preparation.neighbours = std::make_shared<const SurfacePart>(std::move(neighbours));
    for (const auto& patch : cut.patches) append(preparation.cutNeighbours, adjacent(*patch));
}

Vec3 openingOf(const Preparation& preparation) {
    const CavityWalls walls = cavityWalls(preparation.ideal->mesh(), *preparation.original);
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < walls.mesh.triangles.size(); ++i) sum += walls.mesh.areaVector(i);
    int longest = 2;
    for (const int axis : {0, 1}) {
        if (std::abs(sum[axis]) > std::abs(sum[longest])) longest = axis;
    }
    return (sum[longest] < 0 ? -1.0 : 1.0) * Vec3::Unit(longest);
}

}  // namespace tactooth
