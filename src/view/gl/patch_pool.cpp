// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/gl/patch_pool.h"

#include <algorithm>
#include <optional>

#include "geometry/util/parallel_for.h"

namespace tactooth {

namespace {

// Room for a first small cavity (about fifty patches). The buffers double when they are full.
constexpr std::uint32_t kFirstVertices = 8192;
constexpr std::uint32_t kFirstTriangles = 16384;

}  // namespace

PatchPool::PatchPool()
    : buffers_(kFirstVertices, kFirstTriangles), vertices_(kFirstVertices), triangles_(kFirstTriangles) {}

void PatchPool::update(const Surface& surface, const CornerShading& baseShading, const AppearanceZones* zones) {
    takeNew(surface, baseShading);
    markNeighbours();
    uploadStale(*surface.base, baseShading, zones);
    box_ = Box3();
    for (const auto& [id, slot] : slots_) box_.extend(slot.box);
}

/// Removes the patches that are gone and adds the new ones.
void PatchPool::takeNew(const Surface& surface, const CornerShading& baseShading) {
    for (auto& [id, slot] : slots_) slot.wanted = false;
    std::vector<std::shared_ptr<const SurfacePart>> missing;
    for (const auto& patch : surface.patches) {
        const auto known = slots_.find(patch->id());
        if (known != slots_.end()) {
            known->second.wanted = true;
        } else if (!patch->mesh().empty()) {
            missing.push_back(patch);
        }
    }
    changed_ = Box3();
    std::erase_if(slots_, [&](const auto& entry) {
        if (entry.second.wanted) return false;
        changed_.extend(entry.second.box);
        release(entry.second);
        return true;
    });
    for (const auto& patch : missing) changed_.extend(patch->tree().box());
    std::vector<std::optional<ShadedPatch>> shaded(missing.size());
    parallelFor(missing.size(), [&](std::size_t i) { shaded[i].emplace(missing[i], *surface.base, baseShading); });
    for (std::size_t i = 0; i < missing.size(); ++i) slots_.emplace(missing[i]->id(), std::move(*shaded[i]));
}

/// Marks walls that end where a new one begins: they are shaded again together with it.
void PatchPool::markNeighbours() {
    std::vector<const Slot*> fresh;
    for (const auto& [id, slot] : slots_) {
        if (slot.isStale) fresh.push_back(&slot);
    }
    for (auto& [id, slot] : slots_) {
        const Box3& wall = slot.patch.wall;  // clang 14: a lambda cannot capture a structured binding
        const auto meets = [&](const Slot* other) { return other->patch.wall.intersects(wall); };
        slot.isStale = slot.isStale || std::any_of(fresh.begin(), fresh.end(), meets);
    }
}

/// Shades on all processors, then uploads the patches one after the other.
void PatchPool::uploadStale(const SurfacePart& base, const CornerShading& baseShading, const AppearanceZones* zones) {
    std::vector<Slot*> stale;
    for (auto& [id, slot] : slots_) {
        if (slot.isStale) stale.push_back(&slot);
    }
    std::vector<ShadingMesh> meshes(stale.size());
    parallelFor(stale.size(), [&](std::size_t i) {
        const ShadedPatch& patch = stale[i]->patch;
        meshes[i] =
            shadingMesh(patch.part->mesh(), patchShading(patch, neighboursOf(*stale[i]), base, baseShading, zones));
    });
    lastUpload_ = 0;
    for (std::size_t i = 0; i < stale.size(); ++i) upload(*stale[i], std::move(meshes[i]));
}

std::vector<const ShadedPatch*> PatchPool::neighboursOf(const Slot& slot) const {
    std::vector<const ShadedPatch*> neighbours;
    for (const auto& [id, other] : slots_) {
        if (&other != &slot && other.patch.wall.intersects(slot.patch.wall)) neighbours.push_back(&other.patch);
    }
    return neighbours;
}

void PatchPool::upload(Slot& slot, ShadingMesh mesh) {
    release(slot);
    slot.vertices = static_cast<std::uint32_t>(mesh.vertices.size());
    slot.triangles = static_cast<std::uint32_t>(mesh.triangles.size());
    slot.firstVertex = allocateVertices(slot.vertices);
    slot.firstTriangle = allocateTriangles(slot.triangles);
    for (Triangle& triangle : mesh.triangles) {
        for (std::uint32_t& vertex : triangle) vertex += slot.firstVertex;
    }
    for (TriangleCluster& cluster : mesh.clusters) cluster.firstTriangle += slot.firstTriangle;
    buffers_.writeVertices(slot.firstVertex, mesh.vertices);
    buffers_.writeTriangles(slot.firstTriangle, mesh.triangles);
    slot.clusters = std::move(mesh.clusters);
    slot.box = mesh.box;
    slot.isStale = false;
    lastUpload_ += slot.triangles;
}

void PatchPool::release(const Slot& slot) {
    if (slot.triangles == 0) return;
    vertices_.release(slot.firstVertex, slot.vertices);
    triangles_.release(slot.firstTriangle, slot.triangles);
}

std::uint32_t PatchPool::allocateVertices(std::uint32_t count) {
    if (const auto first = vertices_.allocate(count)) return *first;
    const std::uint32_t capacity = std::max(2 * vertices_.capacity(), vertices_.capacity() + count);
    buffers_.growVertices(capacity);
    vertices_.grow(capacity);
    return *vertices_.allocate(count);
}

std::uint32_t PatchPool::allocateTriangles(std::uint32_t count) {
    if (const auto first = triangles_.allocate(count)) return *first;
    const std::uint32_t capacity = std::max(2 * triangles_.capacity(), triangles_.capacity() + count);
    buffers_.growTriangles(capacity);
    triangles_.grow(capacity);
    return *triangles_.allocate(count);
}

void PatchPool::draw(const ClusterCuller& culler) {
    ranges_.clear();
    for (const auto& [id, slot] : slots_) visibleRanges(culler, slot.clusters, ranges_);
    buffers_.draw(ranges_);
}

}  // namespace tactooth
