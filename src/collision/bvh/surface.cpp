// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/bvh/surface.h"

#include <atomic>

#include "geometry/mesh/append_subset.h"
#include "geometry/util/assert.h"

namespace tactooth {
namespace {

std::uint64_t nextPartId() {
    static std::atomic<std::uint64_t> counter{0};
    return ++counter;
}

/// Whether rounding to floats has made a triangle a line. A reader of the file would drop it, and the surface is closed
/// without it.
bool isCollapsed(const TriangleMesh& mesh, const Triangle& triangle) {
    const Vec3f& a = mesh.vertices[triangle[0]];
    const Vec3f& b = mesh.vertices[triangle[1]];
    const Vec3f& c = mesh.vertices[triangle[2]];
    return a == b || b == c || c == a;
}

template <class LeavesOut>
void append(TaggedMesh& result, const SurfacePart& part, const LeavesOut& leavesOut) {
    appendSubset(result.mesh, part.mesh(), [&](std::uint32_t i) {
        if (leavesOut(i)) return false;
        result.tags.push_back(part.tag(i));
        return true;
    });
}

template <class LeavesOut>
TaggedMesh visible(const Surface& surface, const LeavesOut& leavesOut) {
    TaggedMesh result;
    append(result, *surface.base, [&](std::uint32_t i) {
        return (surface.hidden != nullptr && isHidden(*surface.hidden, i)) || leavesOut(*surface.base, i);
    });
    for (const auto& patch : surface.patches) {
        const TriangleMesh& mesh = patch->mesh();
        append(result, *patch,
               [&](std::uint32_t i) { return isCollapsed(mesh, mesh.triangles[i]) || leavesOut(*patch, i); });
    }
    return result;
}

}  // namespace

SurfacePart::SurfacePart(TriangleMesh mesh, std::vector<SurfaceTag> tags, std::uint32_t firstAdjacent, TreeBuild build)
    : mesh_(std::move(mesh)),
      tags_(std::move(tags)),
      firstAdjacent_(firstAdjacent),
      tree_(mesh_, build),
      id_(nextPartId()) {
    TACTOOTH_ASSERT(tags_.empty() || tags_.size() == mesh_.triangles.size());
    TACTOOTH_ASSERT(tree_.empty() == mesh_.empty());
}

void Surface::validate() const {
    TACTOOTH_ASSERT(base != nullptr);
    const std::size_t triangles = base->mesh().triangles.size();
    base->tree().validate();
    TACTOOTH_ASSERT(hidden == nullptr || hidden->empty() || hidden->size() == (triangles + 63) / 64);
    for (const auto& patch : patches) {
        TACTOOTH_ASSERT(patch != nullptr);
        patch->tree().validate();
    }
    if (maskedTree == nullptr) return;
    maskedTree->validate();
    TACTOOTH_ASSERT(base->tree().box().contains(maskedTree->box()));
}

TaggedMesh visibleMesh(const Surface& surface) {
    return visible(surface, [](const SurfacePart&, std::uint32_t) { return false; });
}

TaggedMesh visibleToothMesh(const Surface& surface) {
    return visible(surface, [](const SurfacePart& part, std::uint32_t triangle) { return part.isAdjacent(triangle); });
}

}  // namespace tactooth
