// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>

#include "view/gl/triangle_buffers.h"
#include "view/mesh/patch_shading.h"
#include "view/mesh/range_allocator.h"

namespace tactooth {

/// The patches of one tooth on the graphics card. All of them share one pair of buffers, so that one draw call draws
/// hundreds of patches. An update uploads the patches that are new since the last snapshot, and the patches whose walls
/// continue in them, because both are shaded together.
class PatchPool {
public:
    PatchPool();

    /// Updates the pool to `surface`. `baseShading`: the corner normals of its base. `zones`: SceneObject::zones, or
    /// null.
    void update(const Surface& surface, const CornerShading& baseShading, const AppearanceZones* zones = nullptr);
    void draw(const ClusterCuller& culler);
    [[nodiscard]] const Box3& box() const { return box_; }
    /// The box in which the last update changed the visible geometry. Changes of shading do not count.
    [[nodiscard]] const Box3& changed() const { return changed_; }
    /// Triangles uploaded by the last update.
    [[nodiscard]] std::size_t lastUpload() const { return lastUpload_; }

private:
    struct Slot {
        explicit Slot(ShadedPatch shaded) : patch(std::move(shaded)) {}

        ShadedPatch patch;
        std::uint32_t firstVertex = 0;
        std::uint32_t vertices = 0;
        std::uint32_t firstTriangle = 0;
        std::uint32_t triangles = 0;
        std::vector<TriangleCluster> clusters;
        Box3 box;
        bool wanted = true;
        bool isStale = true;  ///< needs to be shaded and uploaded
    };
    void takeNew(const Surface& surface, const CornerShading& baseShading);
    void markNeighbours();
    void uploadStale(const SurfacePart& base, const CornerShading& baseShading, const AppearanceZones* zones);
    [[nodiscard]] std::vector<const ShadedPatch*> neighboursOf(const Slot& slot) const;
    void upload(Slot& slot, ShadingMesh mesh);
    void release(const Slot& slot);
    [[nodiscard]] std::uint32_t allocateVertices(std::uint32_t count);
    [[nodiscard]] std::uint32_t allocateTriangles(std::uint32_t count);

    TriangleBuffers buffers_;
    RangeAllocator vertices_;
    RangeAllocator triangles_;
    std::map<std::uint64_t, Slot> slots_;  ///< by SurfacePart::id
    std::vector<TriangleRange> ranges_;
    Box3 box_;
    Box3 changed_;
    std::size_t lastUpload_ = 0;
};

}  // namespace tactooth
