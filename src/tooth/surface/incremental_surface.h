// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <unordered_map>
#include <vector>

#include "collision/bvh/masked_bvh.h"
#include "collision/bvh/surface.h"
#include "tooth/surface/base_clipper.h"
#include "tooth/surface/margin_clipper.h"
#include "tooth/surface/patch_bodies.h"
#include "tooth/volume/cut_volume.h"

namespace tactooth {

/// The surface of a tooth while it is cut: the triangles of its file, bit for bit, wherever no bur has been; where one
/// has crossed them, what is left of them; and the walls of the cavities. Both sides of a margin are cut along the
/// very same line, so the surface stays closed. One thread calls `update`; the snapshots go to any number of others.
class IncrementalSurface {
public:
    explicit IncrementalSurface(const CutVolume& volume);

    /// Brings the surface up to what `changed` (the result of a carve) did to `volume`, the volume it was made with.
    void update(const CutVolume& volume, const std::vector<ChangedBrick>& changed);

    /// The surface now. Shares with the one before all that did not change.
    [[nodiscard]] const std::shared_ptr<const Surface>& snapshot() const { return snapshot_; }

    /// The whole tooth again, as after `CutVolume::reset`.
    void reset();

    /// What the bodies around the tooth (SurfacePart::isAdjacent) have lost, mm^3.
    [[nodiscard]] double lostAdjacent() const;

    /// Triangles whose cut lines did not fit together, in all updates: 0 unless the tooth's surface runs through
    /// itself. Each leaves a gap or an overlap of its own size.
    [[nodiscard]] std::size_t failures() const { return failures_; }

    /// Asserts that the mask, the patches and the counts agree with what is kept for each brick, that the snapshot
    /// shows them, and, while `failures` is 0, that the surface is closed: both sides of each rim run along the same
    /// edges. For tests: time in proportion to the surface, and more for its edges.
    void validate() const;

private:
    using Remains = std::vector<std::array<Vec3f, 3>>;  ///< of one triangle of the tooth's surface
    struct TriangleBounds {
        std::uint32_t triangle;  ///< of the tooth's surface
        Vec3f low, high;
    };
    /// What the surface keeps for one brick.
    struct Cell {
        bool knowsBase = false;
        std::vector<TriangleBounds> base;     ///< those that the brick's wall is near or may still come to
        std::vector<std::uint32_t> affected;  ///< those of them of which the last update has changed something
        BrickBodies bodies = BrickBodies::Either;
        std::vector<MarginSegment> margin;
        WallPatch wall;
        bool isNew = false;  ///< the last update has changed the wall
        /// Pieces of the base triangles whose middle lies in this brick, by triangle.
        std::map<std::uint32_t, Remains> remains;
    };
    [[nodiscard]] Surface uncut(std::uint64_t revision) const;
    [[nodiscard]] std::vector<BrickKey> bricksToExtract(const CutVolume& volume,
                                                        const std::vector<ChangedBrick>& changed) const;
    [[nodiscard]] TriangleBounds boxed(std::uint32_t triangle) const;
    void extract(const CutVolume& volume, const BrickKey& key, Cell& cell) const;
    std::vector<std::uint32_t> findAffected(const BrickNeighbourhood& nodes, const BrickKey& key, Cell& cell) const;
    void countMargin(const std::vector<Cell*>& cells, std::uint32_t step);
    [[nodiscard]] std::vector<const MarginSegment*> marginOf(std::uint32_t triangle) const;
    [[nodiscard]] std::vector<std::uint32_t> affectedBase(const std::vector<Cell*>& cells) const;
    [[nodiscard]] std::vector<std::vector<ClipSegment>> cutLines(const std::vector<std::uint32_t>& triangles) const;
    bool setRemains(const BrickKey& home, std::uint32_t triangle, Remains pieces);
    void storeBase(const std::vector<std::uint32_t>& triangles, std::vector<ClippedBaseTriangle> results,
                   std::vector<BrickKey>& dirty);
    [[nodiscard]] std::shared_ptr<const SurfacePart> patchOf(const Cell& cell) const;
    void setPatch(const BrickKey& key, std::shared_ptr<const SurfacePart> patch);
    void publish(const std::vector<BrickKey>& dirty);
    void validateCell(const BrickKey& key, const Cell& cell) const;
    void validateMask() const;

    std::shared_ptr<const SurfacePart> base_;
    Lattice lattice_;
    std::unordered_map<BrickKey, Cell, BrickKeyHash> cells_;
    std::vector<BrickKey> patchKeys_;                          ///< of the bricks that have a patch, ascending
    std::vector<std::shared_ptr<const SurfacePart>> patches_;  ///< theirs
    std::vector<std::uint32_t> marginSegments_;                ///< how many there are of each base triangle
    TriangleMask hidden_;
    MaskedBvh thinner_;  ///< of the same triangles
    std::shared_ptr<const Surface> snapshot_;
    double sixfoldAdjacent_ = 0;  ///< what cutting has added to six times the volume of the bodies around the tooth
    std::size_t adjacentPatches_ = 0;  ///< that hold some of their triangles
    std::size_t failures_ = 0;
    std::uint64_t undosSeen_ = 0;
    bool onlyGrows_ = true;  ///< the removed region, in the update at hand
};

}  // namespace tactooth
