// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/file/exported_mesh.h"

#include <algorithm>
#include <cmath>

#include "geometry/mesh/append_subset.h"
#include "geometry/util/assert.h"
#include "tooth/file/mesh_components.h"

namespace tactooth {
namespace {

/// Counts the visible triangles of the base. They come first in the visible mesh.
std::size_t countOfBase(const Surface& surface) {
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < surface.base->mesh().triangles.size(); ++i) {
        const bool isThere = surface.hidden == nullptr || !isHidden(*surface.hidden, i);
        count += static_cast<std::size_t>(isThere && !surface.base->isAdjacent(i));
    }
    return count;
}

/// Signed volume of the tetrahedron below a triangle, mm^3 (divergence theorem). `from` is a point of the component,
/// since numbers near the origin are more exact.
double volumeBelow(const TriangleMesh& mesh, const Triangle& triangle, const Vec3f& from) {
    const auto corner = [&](int i) { return Vec3((mesh.vertices[triangle[i]] - from).cast<double>()); };
    return corner(0).dot(corner(1).cross(corner(2))) / 6;
}

struct Component {
    double volume = 0;
    bool isCut = false;
};

/// Indexed by the number of a component.
std::vector<Component> measured(const TriangleMesh& mesh, MeshComponents& components, std::size_t ofBase) {
    std::vector<Component> result(components.points().size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::uint32_t number = components.ofVertex(mesh.triangles[t][0]);
        TACTOOTH_ASSERT(number < result.size());
        result[number].volume += volumeBelow(mesh, mesh.triangles[t], components.points()[number]);
        result[number].isCut = result[number].isCut || t >= ofBase;
    }
    return result;
}

}  // namespace

TaggedMesh exportedMesh(const Surface& surface, double voxel) {
    TACTOOTH_ASSERT(surface.base != nullptr);
    TACTOOTH_ASSERT(std::isfinite(voxel) && voxel > 0);
    TaggedMesh whole = visibleToothMesh(surface);
    TACTOOTH_ASSERT(whole.tags.size() == whole.mesh.triangles.size());
    if (surface.patches.empty()) return whole;
    MeshComponents components(whole.mesh);
    const std::vector<Component> all = measured(whole.mesh, components, countOfBase(surface));
    const auto isSpeck = [&](const Component& component) {
        return component.isCut && std::abs(component.volume) < voxel * voxel * voxel;
    };
    if (std::ranges::none_of(all, isSpeck)) return whole;
    TaggedMesh result;
    appendSubset(result.mesh, whole.mesh, [&](std::uint32_t t) {
        if (isSpeck(all[components.ofVertex(whole.mesh.triangles[t][0])])) return false;
        result.tags.push_back(whole.tags[t]);
        return true;
    });
    TACTOOTH_ASSERT(result.tags.size() == result.mesh.triangles.size());
    return result;
}

}  // namespace tactooth
