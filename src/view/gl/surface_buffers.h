// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/gl/patch_pool.h"
#include "view/mesh/lod_tree.h"
#include "view/scene/scene.h"

namespace tactooth {

/// One scene shape on the graphics card, kept in step with the snapshots of a tooth: the base is uploaded once, a
/// triangle that was hidden or came back costs twelve bytes, and only new patches are sent.
class SurfaceBuffers {
public:
    /// Uploads what all snapshots of `shape` share; `update` brings the rest. `shape` has triangles.
    explicit SurfaceBuffers(const SceneShape& shape);

    /// Whether `shape` is what these buffers hold, or another snapshot of it.
    [[nodiscard]] bool holds(const SceneShape& shape) const;
    /// Brings the buffers in step with `shape`, which they hold. Says whether anything changed.
    bool update(const SceneShape& shape);

    void draw(const ClusterCuller& culler);
    /// Object frame.
    [[nodiscard]] Box3 box() const { return box_.merged(patches_.box()); }
    /// Where the last update that changed anything did so, shading apart. Object frame.
    [[nodiscard]] const Box3& changed() const { return changed_; }
    /// Triangles sent to the graphics card by the last update.
    [[nodiscard]] std::size_t lastUpload() const { return lastUpload_; }

private:
    struct Prepared {
        CornerShading shading;
        ShadingMesh mesh;
        LodTree lodTree;
    };
    [[nodiscard]] static Prepared prepare(const SceneShape& shape);
    SurfaceBuffers(const SceneShape& shape, Prepared prepared);
    void hide(const TriangleMask& mask);
    void markChangedNodes();

    SceneShape shown_;  ///< held, so that its address names nothing else
    bool updated_ = false;
    CornerShading shading_;                    ///< of the base
    LodTree lodTree_;                          ///< of the base, with none of its triangles hidden
    std::vector<std::uint32_t> hiddenInNode_;  ///< triangles, of nodes that are pieces of the true surface
    std::vector<bool> mustRefine_;             ///< of each node: whether a triangle below it is hidden
    std::vector<std::uint32_t> drawIndexOfTriangle_;
    Box3 box_;
    Box3 changed_;
    TriangleMask hidden_;
    TriangleBuffers buffers_;
    PatchPool patches_;
    std::vector<TriangleRange> ranges_;
    std::size_t lastUpload_ = 0;
};

/// Whether `shape` has something to draw.
[[nodiscard]] bool hasTriangles(const SceneShape& shape);

}  // namespace tactooth
