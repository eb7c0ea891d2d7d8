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

/// One closed body inside a tooth, as `examineSolid` leaves it.
struct LayerMesh {
    std::string name;  ///< for messages: the user's word for it, unique within a tooth
    MaterialId material;
    TriangleMesh mesh;  ///< closed, welded, normals outward
};

/// How a tooth stands in its frame, and among others.
struct ToothContext {
    double mesialX = 1;                        ///< direction of mesial along x: 1 or -1
    std::uint32_t firstAdjacent = UINT32_MAX;  ///< from this triangle on its outer surface is that of bodies around it
};

/// A tooth before anything is cut: its outer surface, which is what is touched, and the closed layers inside it.
/// Layers may lie side by side or within one another; where several hold a point, the layer whose material has the
/// highest nesting order is there. Immutable.
class LayeredTooth {
public:
    struct Layer {
        std::string name;
        MaterialId material;
        std::shared_ptr<const SurfacePart> part;
    };

    /// Without layers the whole tooth is `body`. Fails with one sentence if a surface is open or inside out, a name is
    /// given twice, or a layer lies outside the tooth.
    [[nodiscard]] static Expected<LayeredTooth> make(TriangleMesh outer, std::vector<LayerMesh> layers = {},
                                                     MaterialId body = MaterialId{},
                                                     const ToothContext& toothContext = {},
                                                     const MaterialRegistry& materials = builtinMaterials());

    /// What its MaterialIds mean.
    [[nodiscard]] const MaterialRegistry& materials() const { return *materials_; }

    /// The surface that is touched; each triangle's tag is the MaterialId just behind it.
    [[nodiscard]] const std::shared_ptr<const SurfacePart>& outer() const { return outer_; }
    /// The same without what stands around the tooth: made anew where something does.
    [[nodiscard]] std::shared_ptr<const SurfacePart> ownOuter() const;
    /// In rising nesting order.
    [[nodiscard]] const std::vector<Layer>& layers() const { return layers_; }
    /// Whether bodies around the tooth reach into it, or into each other: then the nearest triangle does not tell what
    /// is inside. What two of them claim counts as air.
    [[nodiscard]] bool bodiesOverlap() const { return bodiesOverlap_; }
    /// What the tooth is made of where it has no layers.
    [[nodiscard]] MaterialId body() const { return body_; }
    [[nodiscard]] const ToothContext& toothContext() const { return toothContext_; }
    /// Of the tooth without what stands around it, mm.
    [[nodiscard]] Box3 ownBox() const;

    /// The material at a point inside the tooth, mm. A point in a gap between layers belongs to the nearest one.
    [[nodiscard]] MaterialId materialAt(const Vec3& point) const;

private:
    LayeredTooth() = default;
    [[nodiscard]] std::vector<SurfaceTag> tagsOf(const TriangleMesh& outer) const;

    std::shared_ptr<const SurfacePart> outer_;
    std::vector<Layer> layers_;
    const MaterialRegistry* materials_ = nullptr;
    MaterialId body_{};
    ToothContext toothContext_;
    bool bodiesOverlap_ = false;
};

}  // namespace tactooth
