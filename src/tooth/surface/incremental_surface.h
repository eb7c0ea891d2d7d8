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

/// The surface of a tooth while it is cut. Where no bur has been, it has the triangles of the file, bit for bit.
/// Triangles that a bur has crossed are clipped. The walls of the cavities are added. Wall and tooth are clipped along
/// the same line, so that the surface stays closed. One thread calls `update`; any number of threads may read the
/// snapshots.
class IncrementalSurface {
public:
    /// Of the uncut tooth; `revision`: of the first snapshot.
    explicit IncrementalSurface(const CutVolume& volume, std::uint64_t revision = 0);

    /// Brings the surface up to date after a carve. `changed` is the result of the carve in `volume`. `volume` is the
    /// one of the constructor.
    void update(const CutVolume& volume, const std::vector<ChangedBrick>& changed);

    /// The current surface. It shares all unchanged parts with the snapshot before.
    [[nodiscard]] const std::shared_ptr<const Surface>& snapshot() const { return snapshot_; }

    /// Restores the surface of the uncut tooth, as after `CutVolume::reset`.
    void reset();

    /// The volume that the bodies around the tooth (SurfacePart::isAdjacent) have lost, mm^3.
    [[nodiscard]] double lostAdjacent() const;

    /// Number of triangles with inconsistent cut lines in all updates. It is 0 unless the tooth's surface intersects
    /// itself. Each such triangle leaves a gap or an overlap of its own size.
    [[nodiscard]] std::size_t failures() const { return failures_; }

    /// Asserts that the mask, the patches and the counters agree with the data of each brick, and that the snapshot
    /// shows them. While `failures` is 0, also asserts that the surface is closed: at each margin both sides share the
    /// same edges. For tests: takes time in proportion to the surface, n log n for its edges.
    void validate() const;

private:
    using Remains = std::vector<std::array<Vec3f, 3>>;  ///< of one triangle of the tooth's surface
    struct TriangleBounds {
        std::uint32_t triangle;  ///< of the tooth's surface
        Vec3f low, high;
    };
    /// The data of one brick.
    struct Cell {
        bool knowsBase = false;
        std::vector<TriangleBounds> base;     ///< base triangles that the brick's wall touches or may still reach
        std::vector<std::uint32_t> affected;  ///< those of `base` that the last update may have changed
        BrickBodies bodies = BrickBodies::Either;
        std::vector<MarginSegment> margin;
        WallPatch wall;
        bool isNew = false;  ///< the last update has changed the wall
        /// Clipped pieces of the base triangles whose centroid lies in this brick, by triangle.
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
    bool closed_;  // Surface::closed
    Lattice lattice_;
    std::unordered_map<BrickKey, Cell, BrickKeyHash> cells_;
    std::vector<BrickKey> patchKeys_;                          ///< of the bricks that have a patch, in ascending order
    std::vector<std::shared_ptr<const SurfacePart>> patches_;  ///< the patches of these bricks
    std::vector<std::uint32_t> marginSegments_;                ///< number of margin segments of each base triangle
    TriangleMask hidden_;
    MaskedBvh maskedBvh_;  ///< of the base, without hidden triangles
    std::shared_ptr<const Surface> snapshot_;
    double sixfoldAdjacent_ = 0;       ///< change of six times the volume of the bodies around the tooth
    std::size_t adjacentPatches_ = 0;  ///< number of patches with triangles of these bodies
    std::size_t failures_ = 0;
    std::uint64_t restorationsSeen_ = 0;
    bool onlyGrows_ = true;  ///< whether the removed region only grows in the current update
};

}  // namespace tactooth
