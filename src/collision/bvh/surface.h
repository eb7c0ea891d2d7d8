// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "collision/bvh/aabb_tree.h"
#include "geometry/mesh/triangle_mesh.h"
#include "geometry/util/assert.h"

namespace tactooth {

/// A number that the owner of a surface gives to each triangle (for a tooth: the material behind it).
using SurfaceTag = std::uint8_t;

/// A piece of surface for collision detection: triangles, one tag each, and their AABB tree. Immutable, so any number
/// of threads may read it.
class SurfacePart {
public:
    /// `tags` holds one tag for each triangle, or is empty (then every tag is 0). Triangles from `firstAdjacent` on
    /// belong to bodies around the tooth.
    explicit SurfacePart(TriangleMesh mesh, std::vector<SurfaceTag> tags = {},
                         std::uint32_t firstAdjacent = kNoneAdjacent, TreeBuild build = TreeBuild::Best);

    static constexpr std::uint32_t kNoneAdjacent = UINT32_MAX;

    [[nodiscard]] const TriangleMesh& mesh() const { return mesh_; }
    [[nodiscard]] const std::vector<SurfaceTag>& tags() const { return tags_; }
    [[nodiscard]] SurfaceTag tag(std::uint32_t triangle) const {
        TACTOOTH_ASSERT(triangle < mesh_.triangles.size());
        return tags_.empty() ? SurfaceTag{0} : tags_[triangle];
    }
    [[nodiscard]] std::uint32_t firstAdjacent() const { return firstAdjacent_; }
    [[nodiscard]] bool isAdjacent(std::uint32_t triangle) const { return triangle >= firstAdjacent_; }
    [[nodiscard]] const AabbTree& tree() const { return tree_; }
    /// A number that no other part of this process has. Data computed for a part stays valid as long as its id.
    [[nodiscard]] std::uint64_t id() const { return id_; }

private:
    TriangleMesh mesh_;
    std::vector<SurfaceTag> tags_;
    std::uint32_t firstAdjacent_;
    AabbTree tree_;
    std::uint64_t id_;
};

/// One bit for each triangle of the base part. Set: the triangle has been cut away, or pieces of it in a patch replace
/// it. Then it is neither used for collision, nor drawn, nor exported.
using TriangleMask = std::vector<std::uint64_t>;

[[nodiscard]] inline bool isHidden(const TriangleMask& mask, std::uint32_t triangle) {
    TACTOOTH_ASSERT(mask.empty() || triangle / 64 < mask.size());
    return !mask.empty() && ((mask[triangle / 64] >> (triangle % 64)) & 1U) != 0;
}

/// The whole surface of a tooth at one moment: the triangles of the file, without those that were cut away, plus the
/// patches of the cut. An immutable snapshot; a later one shares every part that did not change. Collision, view and
/// export all use this object.
struct Surface {
    std::shared_ptr<const SurfacePart> base;               ///< triangles of the file; never null
    std::shared_ptr<const TriangleMask> hidden = nullptr;  ///< of `base`; null: no triangle is hidden
    std::vector<std::shared_ptr<const SurfacePart>> patches = {};
    std::uint64_t revision = 0;  ///< grows by one with every snapshot of the same tooth
    bool closed = true;          ///< whether the surface has an inside; false: only its triangles count
    /// The tree of the base without the hidden triangles; null: it was not made.
    std::shared_ptr<const AabbTree> maskedTree = nullptr;

    /// Asserts every invariant, in O(n): parts, mask and masked tree agree.
    void validate() const;
};

/// A part of `surface` by its number: 0 = the base, i + 1 = patch i.
[[nodiscard]] inline const SurfacePart& partOf(const Surface& surface, std::uint32_t part) {
    TACTOOTH_ASSERT(part <= surface.patches.size());
    return part == 0 ? *surface.base : *surface.patches[part - 1];
}

/// The tree to search for triangles of the base, and the mask that hides some of its triangles (null: none is hidden).
struct VisibleBase {
    const AabbTree& tree;
    const TriangleMask* hidden;
};
[[nodiscard]] inline VisibleBase visibleBase(const Surface& surface) {
    TACTOOTH_ASSERT(surface.base != nullptr);
    if (surface.maskedTree != nullptr) return {*surface.maskedTree, nullptr};
    return {surface.base->tree(), surface.hidden.get()};
}

/// Every visible triangle of `surface` with its tag, as one mesh. Triangles of the base come first, in the order and
/// with the coordinates of their file. Triangles of patches with two equal corners are left out.
struct TaggedMesh {
    TriangleMesh mesh;
    std::vector<SurfaceTag> tags;
};
[[nodiscard]] TaggedMesh visibleMesh(const Surface& surface);
/// The same of the tooth alone, without bodies around it.
[[nodiscard]] TaggedMesh visibleToothMesh(const Surface& surface);

}  // namespace tactooth
