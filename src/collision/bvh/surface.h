// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "collision/bvh/aabb_tree.h"
#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// A number that the owner of a surface gives to each triangle (a tooth writes the material behind it).
using SurfaceTag = std::uint8_t;

/// A piece of surface that can be felt: triangles, one tag each, and their AABB tree. Never changes once made, so any
/// number of threads may read it.
class SurfacePart {
public:
    /// `tags` holds one tag a triangle, or nothing (every tag is then 0). Triangles from `firstAdjacent` on belong to
    /// bodies around the tooth.
    explicit SurfacePart(TriangleMesh mesh, std::vector<SurfaceTag> tags = {},
                         std::uint32_t firstAdjacent = kNoneAdjacent, TreeBuild build = TreeBuild::Best);

    static constexpr std::uint32_t kNoneAdjacent = UINT32_MAX;

    [[nodiscard]] const TriangleMesh& mesh() const { return mesh_; }
    [[nodiscard]] const std::vector<SurfaceTag>& tags() const { return tags_; }
    [[nodiscard]] SurfaceTag tag(std::uint32_t triangle) const {
        return tags_.empty() ? SurfaceTag{0} : tags_[triangle];
    }
    [[nodiscard]] std::uint32_t firstAdjacent() const { return firstAdjacent_; }
    [[nodiscard]] bool isAdjacent(std::uint32_t triangle) const { return triangle >= firstAdjacent_; }
    [[nodiscard]] const AabbTree& tree() const { return tree_; }
    /// A number that no other part of this process has: what was computed for a part stays valid as long as its id.
    [[nodiscard]] std::uint64_t id() const { return id_; }

private:
    TriangleMesh mesh_;
    std::vector<SurfaceTag> tags_;
    std::uint32_t firstAdjacent_;
    AabbTree tree_;
    std::uint64_t id_;
};

/// One bit a triangle of the base part: set = the triangle has been cut away (or was replaced by pieces of it that
/// live in a patch) and is neither felt, drawn nor exported.
using TriangleMask = std::vector<std::uint64_t>;

[[nodiscard]] inline bool isHidden(const TriangleMask& mask, std::uint32_t triangle) {
    return !mask.empty() && ((mask[triangle / 64] >> (triangle % 64)) & 1U) != 0;
}

/// The whole surface of a tooth at one moment: the STL as it came, minus the triangles that were cut, plus the
/// patches that cutting has made. An immutable snapshot; a later one shares every part that did not change. This one
/// object is what is felt (collision), seen (view) and exported.
struct Surface {
    std::shared_ptr<const SurfacePart> base;
    std::shared_ptr<const TriangleMask> hidden = nullptr;  ///< of `base`; null = nothing hidden
    std::vector<std::shared_ptr<const SurfacePart>> patches = {};
    std::uint64_t revision = 0;  ///< grows by one with every snapshot of the same tooth
    bool closed = true;          ///< whether "inside" has a meaning; false: only the triangles themselves are felt
    /// The base's tree without the hidden triangles, for those who walk; null: nobody has made it.
    std::shared_ptr<const AabbTree> maskedTree = nullptr;
};

/// The part of `surface` that a number names: 0 = the surface's base, i + 1 = its patch i.
[[nodiscard]] inline const SurfacePart& partOf(const Surface& surface, std::uint32_t part) {
    return part == 0 ? *surface.base : *surface.patches[part - 1];
}

/// The tree to look for triangles of the base in, and the mask that those found are to be held against (null: none is
/// hidden).
struct VisibleBase {
    const AabbTree& tree;
    const TriangleMask* hidden;
};
[[nodiscard]] inline VisibleBase visibleBase(const Surface& surface) {
    if (surface.maskedTree != nullptr) return {*surface.maskedTree, nullptr};
    return {surface.base->tree(), surface.hidden.get()};
}

/// Every triangle of `surface` that can be seen, with its tag, as one mesh. Base triangles come first, in the order
/// and with the coordinates of the file that they were read from. Triangles of patches with two equal corners are left
/// out.
struct TaggedMesh {
    TriangleMesh mesh;
    std::vector<SurfaceTag> tags;
};
[[nodiscard]] TaggedMesh visibleMesh(const Surface& surface);
/// The same of the tooth alone, without bodies around it.
[[nodiscard]] TaggedMesh visibleToothMesh(const Surface& surface);

}  // namespace tactooth
