// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/gl/patch_pool.h"
#include "view/mesh/lod_tree.h"
#include "view/scene/scene.h"

namespace tactooth {

/// One scene shape on the graphics card, kept up to date with the snapshots of a tooth. The base is uploaded once. A
/// triangle that is hidden or shown again costs twelve bytes. Only new patches are uploaded.
class SurfaceBuffers {
public:
    /// Uploads the data that all snapshots of `shape` share; `update` uploads the rest. `shape` has triangles.
    explicit SurfaceBuffers(const SceneShape& shape, std::shared_ptr<const AppearanceZones> zones = nullptr);

    /// Whether these buffers hold `shape` or another snapshot of it.
    [[nodiscard]] bool holds(const SceneShape& shape) const;
    /// Updates the buffers to `shape`, which they must hold. Returns whether anything changed.
    bool update(const SceneShape& shape);

    void draw(const ClusterCuller& culler);
    /// Object frame.
    [[nodiscard]] Box3 box() const { return box_.merged(patches_.box()); }
    /// The box of the last update that changed anything; changes of shading do not count. Object frame.
    [[nodiscard]] const Box3& changed() const { return changed_; }
    /// Triangles uploaded to the graphics card by the last update.
    [[nodiscard]] std::size_t lastUpload() const { return lastUpload_; }

private:
    struct Prepared {
        CornerShading shading;
        ShadingMesh mesh;
        LodTree lodTree;
    };
    [[nodiscard]] static Prepared prepare(const SceneShape& shape, const AppearanceZones* zones);
    SurfaceBuffers(const SceneShape& shape, std::shared_ptr<const AppearanceZones> zones, Prepared prepared);
    void hide(const TriangleMask& mask);
    void markChangedNodes();

    SceneShape shown_;  ///< kept alive, so that no other shape can get its address
    std::shared_ptr<const AppearanceZones> zones_;
    bool updated_ = false;
    CornerShading shading_;                    ///< of the base
    LodTree lodTree_;                          ///< of the base, with none of its triangles hidden
    std::vector<std::uint32_t> hiddenInNode_;  ///< hidden triangles of each node that is a piece of the true surface
    std::vector<bool> mustRefine_;             ///< for each node: whether a triangle below it is hidden
    std::vector<std::uint32_t> drawIndexOfTriangle_;
    Box3 box_;
    Box3 changed_;
    TriangleMask hidden_;
    TriangleBuffers buffers_;
    PatchPool patches_;
    std::vector<TriangleRange> ranges_;
    std::size_t lastUpload_ = 0;
};

/// Whether `shape` has triangles to draw.
[[nodiscard]] bool hasTriangles(const SceneShape& shape);

}  // namespace tactooth
