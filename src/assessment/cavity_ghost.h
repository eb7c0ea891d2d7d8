// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "assessment/cavity_walls.h"
#include "session/simulation/surface_change.h"

namespace tactooth {

/// The tags of a ghost's triangles.
inline constexpr SurfaceTag kGhostWall = 0, kGhostRim = 1, kGhostRimGap = 2;

/// The target cavity as a mesh inside the tooth: its walls, and a thin cord along their rim, which is the outline of
/// the cavity on the surface of the tooth. Walls that the cut has reached are hidden.
class CavityGhost {
public:
    /// `outer`: the uncut tooth, closed. Takes a second for a large tooth.
    CavityGhost(const TriangleMesh& target, const SurfacePart& outer)
        : CavityGhost(cavityWalls(target, outer), outer) {}
    /// The same; `walls` are those of the target in `outer`.
    CavityGhost(CavityWalls walls, const SurfacePart& outer);

    /// Whether the target has nothing to cut.
    [[nodiscard]] bool empty() const { return shown_.base->mesh().empty(); }

    /// The ghost for a snapshot of the tooth: walls with tooth still before them (kGhostWall), and the whole rim
    /// (kGhostRim, and kGhostRimGap where a dashed line has its gaps). Returns the same pointer as long as nothing
    /// changes. Fast where `tooth` differs little from that of the last call.
    [[nodiscard]] std::shared_ptr<const Surface> over(const std::shared_ptr<const Surface>& tooth);

private:
    /// Wall triangles near each other, which are reached together.
    struct GhostPatch {
        Vec3f before;              // a point in the cavity, near before the middle of one of them
        std::uint32_t first, end;  // of them
    };
    void divideIntoPatches(TriangleMesh& walls, const SurfacePart& outer);
    void show(const GhostPatch& spot, bool shows);

    Surface shown_;
    std::vector<GhostPatch> ghostPatches_;
    TriangleMask reached_;
    SurfaceChange change_;
    std::shared_ptr<const Surface> last_;
};

}  // namespace tactooth
