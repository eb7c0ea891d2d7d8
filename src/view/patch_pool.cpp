// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/patch_pool.h"

#include <algorithm>

namespace tactooth {

namespace {

// Room for a first small cavity (some fifty patches); the buffers double when they are full.
constexpr std::uint32_t kFirstVertices = 8192;
constexpr std::uint32_t kFirstTriangles = 16384;

}  // namespace

PatchPool::PatchPool()
    : buffers_(kFirstVertices, kFirstTriangles), vertices_(kFirstVertices), triangles_(kFirstTriangles) {}

void PatchPool::update(const Surface& surface, const CornerShading& baseShading) {
    for (auto& [id, place] : places_) place.wanted = false;
    std::vector<const SurfacePart*> missing;
    for (const auto& patch : surface.patches) {
        const auto known = places_.find(patch->id());
        if (known == places_.end()) {
            missing.push_back(patch.get());
        } else {
            known->second.wanted = true;
        }
    }
    std::erase_if(places_, [&](const auto& entry) {
        if (!entry.second.wanted) release(entry.second);
        return !entry.second.wanted;
    });
    lastUpload_ = 0;
    for (const SurfacePart* patch : missing) {
        if (patch->mesh().empty()) continue;
        places_.emplace(patch->id(), upload(*patch, *surface.base, baseShading));
        lastUpload_ += patch->mesh().triangles.size();
    }
    box_ = Box3();
    for (const auto& [id, place] : places_) box_.extend(place.box);
}

PatchPool::Place PatchPool::upload(const SurfacePart& patch, const SurfacePart& base,
                                   const CornerShading& baseShading) {
    ShadingMesh mesh = shadingMesh(patch.mesh(), patchShading(patch, base, baseShading));
    Place place;
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
    return place;
}

void PatchPool::release(const Place& place) {
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
