// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/gl/patch_pool.h"

#include <algorithm>
#include <optional>

#include "geometry/util/parallel_for.h"

namespace tactooth {

namespace {

// Room for a first small cavity (some fifty patches); the buffers double when they are full.
constexpr std::uint32_t kFirstVertices = 8192;
constexpr std::uint32_t kFirstTriangles = 16384;

}  // namespace

PatchPool::PatchPool()
    : buffers_(kFirstVertices, kFirstTriangles), vertices_(kFirstVertices), triangles_(kFirstTriangles) {}

void PatchPool::update(const Surface& surface, const CornerShading& baseShading) {
    takeNew(surface, baseShading);
    markNeighbours();
    uploadStale(*surface.base, baseShading);
    box_ = Box3();
    for (const auto& [id, place] : places_) box_.extend(place.box);
}

/// Lets go of the patches that are gone and takes in those that have come.
void PatchPool::takeNew(const Surface& surface, const CornerShading& baseShading) {
    for (auto& [id, place] : places_) place.wanted = false;
    std::vector<std::shared_ptr<const SurfacePart>> missing;
    for (const auto& patch : surface.patches) {
        const auto known = places_.find(patch->id());
        if (known != places_.end()) {
            known->second.wanted = true;
        } else if (!patch->mesh().empty()) {
            missing.push_back(patch);
        }
    }
    changed_ = Box3();
    std::erase_if(places_, [&](const auto& entry) {
        if (entry.second.wanted) return false;
        changed_.extend(entry.second.box);
        release(entry.second);
        return true;
    });
    for (const auto& patch : missing) changed_.extend(patch->tree().box());
    std::vector<std::optional<ShadedPatch>> shaded(missing.size());
    parallelFor(missing.size(), [&](std::size_t i) { shaded[i].emplace(missing[i], *surface.base, baseShading); });
    for (std::size_t i = 0; i < missing.size(); ++i) places_.emplace(missing[i]->id(), std::move(*shaded[i]));
}

/// A wall that ends where a new one begins is shaded anew with it.
void PatchPool::markNeighbours() {
    std::vector<const Place*> fresh;
    for (const auto& [id, place] : places_) {
        if (place.isStale) fresh.push_back(&place);
    }
    for (auto& [id, place] : places_) {
        const Box3& wall = place.patch.wall;  // clang 14 lets no lambda take a binding
        const auto meets = [&](const Place* other) { return other->patch.wall.intersects(wall); };
        place.isStale = place.isStale || std::any_of(fresh.begin(), fresh.end(), meets);
    }
}

/// Shades on all processors, then sends one after the other.
void PatchPool::uploadStale(const SurfacePart& base, const CornerShading& baseShading) {
    std::vector<Place*> stale;
    for (auto& [id, place] : places_) {
        if (place.isStale) stale.push_back(&place);
    }
    std::vector<ShadingMesh> meshes(stale.size());
    parallelFor(stale.size(), [&](std::size_t i) {
        const ShadedPatch& patch = stale[i]->patch;
        meshes[i] = shadingMesh(patch.part->mesh(), patchShading(patch, neighboursOf(*stale[i]), base, baseShading));
    });
    lastUpload_ = 0;
    for (std::size_t i = 0; i < stale.size(); ++i) upload(*stale[i], std::move(meshes[i]));
}

std::vector<const ShadedPatch*> PatchPool::neighboursOf(const Place& place) const {
    std::vector<const ShadedPatch*> neighbours;
    for (const auto& [id, other] : places_) {
        if (&other != &place && other.patch.wall.intersects(place.patch.wall)) neighbours.push_back(&other.patch);
    }
    return neighbours;
}

void PatchPool::upload(Place& place, ShadingMesh mesh) {
    release(place);
    place.vertices = static_cast<std::uint32_t>(mesh.vertices.size());
    place.triangles = static_cast<std::uint32_t>(mesh.triangles.size());
    place.firstVertex = claimVertices(place.vertices);
    place.firstTriangle = claimTriangles(place.triangles);
    for (Triangle& triangle : mesh.triangles) {
        for (std::uint32_t& vertex : triangle) vertex += place.firstVertex;
    }
    for (TriangleCluster& cluster : mesh.clusters) cluster.firstTriangle += place.firstTriangle;
    buffers_.writeVertices(place.firstVertex, mesh.vertices);
    buffers_.writeTriangles(place.firstTriangle, mesh.triangles);
    place.clusters = std::move(mesh.clusters);
    place.box = mesh.box;
    place.isStale = false;
    lastUpload_ += place.triangles;
}

void PatchPool::release(const Place& place) {
    if (place.triangles == 0) return;
    vertices_.release(place.firstVertex, place.vertices);
    triangles_.release(place.firstTriangle, place.triangles);
}

std::uint32_t PatchPool::claimVertices(std::uint32_t count) {
    if (const auto first = vertices_.allocate(count)) return *first;
    const std::uint32_t capacity = std::max(2 * vertices_.capacity(), vertices_.capacity() + count);
    buffers_.growVertices(capacity);
    vertices_.grow(capacity);
    return *vertices_.allocate(count);
}

std::uint32_t PatchPool::claimTriangles(std::uint32_t count) {
    if (const auto first = triangles_.allocate(count)) return *first;
    const std::uint32_t capacity = std::max(2 * triangles_.capacity(), triangles_.capacity() + count);
    buffers_.growTriangles(capacity);
    triangles_.grow(capacity);
    return *triangles_.allocate(count);
}

void PatchPool::draw(const ClusterCuller& culler) {
    runs_.clear();
    for (const auto& [id, place] : places_) visibleRuns(culler, place.clusters, runs_);
    buffers_.draw(runs_);
}

}  // namespace tactooth
