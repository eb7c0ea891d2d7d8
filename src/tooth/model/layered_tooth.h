// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision/bvh/surface.h"
#include "geometry/util/expected.h"
#include "tooth/model/material_registry.h"

namespace tactooth {

/// One closed body inside a tooth. examineSolid has checked it.
struct LayerMesh {
    std::string name;  ///< the user's name for it, unique within a tooth; used in messages
    MaterialId material;
    TriangleMesh mesh;  ///< closed, welded, normals outward
};

/// The orientation of a tooth in its frame, and its neighbours.
struct ToothContext {
    double mesialX = 1;                        ///< direction of mesial along x: 1 or -1
    std::uint32_t firstAdjacent = UINT32_MAX;  ///< first triangle of bodies around the tooth
};

/// A tooth before anything is cut: its outer surface and the closed layers inside it. The tool touches the outer
/// surface. Layers may lie side by side or within one another. Where several layers hold a point, the one whose
/// material has the highest nesting order decides. Immutable.
class LayeredTooth {
public:
    struct Layer {
        std::string name;
        MaterialId material;
        std::shared_ptr<const SurfacePart> part;
    };

    /// Makes a tooth. Without layers the whole tooth is `body`. `toothContext.mesialX` is 1 or -1. Fails with one
    /// sentence if a surface is open or inside out, a name is given twice, or a layer lies outside the tooth.
    [[nodiscard]] static Expected<LayeredTooth> make(TriangleMesh outer, std::vector<LayerMesh> layers = {},
                                                     MaterialId body = MaterialId{},
                                                     const ToothContext& toothContext = {},
                                                     const MaterialRegistry& materials = builtinMaterials());

    /// A surface that is only touched, and never cut: it may be open. `closed`: whether it has an inside. `surface` is
    /// not null; its tags are materials of `materials`.
    [[nodiscard]] static LayeredTooth touchOnly(std::shared_ptr<const SurfacePart> surface, bool closed,
                                                const MaterialRegistry& materials = builtinMaterials());
    /// Whether it comes from `touchOnly`.
    [[nodiscard]] bool isTouchOnly() const { return touchOnly_; }
    /// Whether the outer surface has an inside. False only for an open surface that is only touched.
    [[nodiscard]] bool isClosed() const { return closed_; }

    /// What its MaterialIds mean.
    [[nodiscard]] const MaterialRegistry& materials() const { return *materials_; }

    /// The outer surface. The tag of each triangle is the MaterialId just behind it.
    [[nodiscard]] const std::shared_ptr<const SurfacePart>& outer() const { return outer_; }
    /// The outer surface without the bodies around the tooth. Builds a new part if there are such bodies.
    [[nodiscard]] std::shared_ptr<const SurfacePart> ownOuter() const;
    /// In ascending nesting order: a later layer overrides an earlier one.
    [[nodiscard]] const std::vector<Layer>& layers() const { return layers_; }
    /// Whether bodies around the tooth overlap it or each other. Then the nearest triangle does not show what is
    /// inside, and the region that two of them share counts as air.
    [[nodiscard]] bool bodiesOverlap() const { return bodiesOverlap_; }
    /// The material of a tooth without layers.
    [[nodiscard]] MaterialId body() const { return body_; }
    [[nodiscard]] const ToothContext& toothContext() const { return toothContext_; }
    /// Bounding box of the tooth without the bodies around it, mm.
    [[nodiscard]] Box3 ownBox() const;

    /// The material at a point inside the tooth, mm. In a gap between layers the nearest layer decides.
    [[nodiscard]] MaterialId materialAt(const Vec3& point) const;

    /// Asserts the invariants: closed surfaces with outward normals, one tag for each triangle, unique names, layers in
    /// ascending nesting order. Takes time in proportion to the number of triangles.
    void validate() const;

private:
    LayeredTooth() = default;
    [[nodiscard]] std::vector<SurfaceTag> tagsOf(const TriangleMesh& outer) const;

    std::shared_ptr<const SurfacePart> outer_;
    std::vector<Layer> layers_;
    const MaterialRegistry* materials_ = nullptr;
    MaterialId body_{};
    ToothContext toothContext_;
    bool bodiesOverlap_ = false;
    bool touchOnly_ = false;
    bool closed_ = true;
};

}  // namespace tactooth
