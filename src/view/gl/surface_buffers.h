// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/mesh/detail_tree.h"
#include "view/gl/patch_pool.h"
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
        DetailTree detail;
    };
    [[nodiscard]] static Prepared prepare(const SceneShape& shape);
    SurfaceBuffers(const SceneShape& shape, Prepared prepared);
    void hide(const TriangleMask& mask);
    void markHurtNodes();

    SceneShape shown_;  ///< held, so that its address names nothing else
    bool updated_ = false;
    CornerShading shading_;                    ///< of the base
    DetailTree detail_;                        ///< of the base, with none of its triangles hidden
    std::vector<std::uint32_t> hiddenOfNode_;  ///< triangles, of nodes that are pieces of the true surface
    std::vector<bool> mustBeTrue_;             ///< of each node: whether a triangle below it is hidden
    std::vector<std::uint32_t> placeOfTriangle_;
    Box3 box_;
    Box3 changed_;
    TriangleMask hidden_;
    TriangleBuffers buffers_;
    PatchPool patches_;
    std::vector<TriangleRun> runs_;
    std::size_t lastUpload_ = 0;
};

/// Whether `shape` has something to draw.
[[nodiscard]] bool hasTriangles(const SceneShape& shape);

}  // namespace tactooth
