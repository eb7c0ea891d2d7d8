// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/surface.h"

#include <atomic>
#include <cassert>

namespace tactooth {
namespace {

std::uint64_t nextPartId() {
    static std::atomic<std::uint64_t> counter{0};
    return ++counter;
}

void appendVisible(TaggedMesh& result, const SurfacePart& part, const TriangleMask& hidden) {
    const TriangleMesh& mesh = part.mesh();
    std::vector<std::uint32_t> renumbered(mesh.vertices.size(), UINT32_MAX);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        if (isHidden(hidden, i)) continue;
        Triangle triangle;
        for (int corner = 0; corner < 3; ++corner) {
            std::uint32_t& vertex = renumbered[mesh.triangles[i][corner]];
            if (vertex == UINT32_MAX) {
                vertex = static_cast<std::uint32_t>(result.mesh.vertices.size());
                result.mesh.vertices.push_back(mesh.vertices[mesh.triangles[i][corner]]);
            }
            triangle[corner] = vertex;
        }
        result.mesh.triangles.push_back(triangle);
        result.tags.push_back(part.tag(i));
    }
}

}  // namespace

SurfacePart::SurfacePart(TriangleMesh mesh, std::vector<SurfaceTag> tags)
    : mesh_(std::move(mesh)), tags_(std::move(tags)), tree_(mesh_), id_(nextPartId()) {
    assert(tags_.empty() || tags_.size() == mesh_.triangles.size());
}

TaggedMesh visibleMesh(const Surface& surface) {
    TaggedMesh result;
    appendVisible(result, *surface.base, surface.hidden != nullptr ? *surface.hidden : TriangleMask{});
    for (const auto& patch : surface.patches) appendVisible(result, *patch, TriangleMask{});
    return result;
}

}  // namespace tactooth
