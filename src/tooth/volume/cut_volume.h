// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "geometry/util/assert.h"
#include "tooth/model/layered_tooth.h"
#include "tooth/sweep/revolution_envelope.h"
#include "tooth/volume/brick_map.h"
#include "tooth/volume/brick_pool.h"
#include "tooth/volume/carve_result.h"
#include "tooth/volume/cut_journal.h"
#include "tooth/volume/detached_pieces.h"
#include "tooth/volume/planned_removal.h"

namespace tactooth {

/// Default clearance in voxels: how much wider than the bur the cut is. It exceeds the distance between the cut and the
/// triangles that approximate it, so that a bur at rest in its own cut does not touch them. A flat bur of 1 mm in a
/// slot that it has milled at 50 um touches nothing with 0.1; with 0.04 the triangles reach 1.6 um into the bur. Use 0
/// to measure the removed volume itself.
inline constexpr double kDefaultClearance = 0.1;

/// The part of a tooth that burs have removed: a sparse volume of bricks. Bricks are made when a bur comes near. One
/// thread writes. The work runs on all cores, and the result is the same for any number of them.
class CutVolume {
public:
    /// `tooth` is not null. `voxel` is the spacing of the nodes, mm.
    CutVolume(std::shared_ptr<const LayeredTooth> tooth, double voxel);

    /// Sets the pool of bricks made ahead. It is for the same tooth and spacing. Null: each brick is made when it is
    /// needed. Changes no result.
    void setPool(std::shared_ptr<BrickPool> pool) {
        TACTOOTH_ASSERT(pool == nullptr || pool->isFor(tooth_, lattice_.spacing()));
        pool_ = std::move(pool);
    }

    /// Removes what `envelope`, dilated by `clearance` (mm, not negative), sweeps between two poses of the tool in the
    /// tooth's frame. Volumes are counted with subvoxel accuracy: to about 0.1 % of a cut some voxels wide.
    CarveResult carve(const RevolutionEnvelope& envelope, const Pose& fromInTooth, const Pose& toInTooth,
                      double clearance);
    CarveResult carve(const RevolutionEnvelope& envelope, const Pose& fromInTooth, const Pose& toInTooth) {
        return carve(envelope, fromInTooth, toInTooth, kDefaultClearance * lattice_.spacing());
    }

    /// Returns what the same `carve` would remove. Changes nothing, but keeps bricks that it had to make. The envelope
    /// must outlive the result.
    [[nodiscard]] PlannedRemoval removable(const RevolutionEnvelope& envelope, const Pose& fromInTooth,
                                           const Pose& toInTooth, double clearance);
    [[nodiscard]] PlannedRemoval removable(const RevolutionEnvelope& envelope, const Pose& fromInTooth,
                                           const Pose& toInTooth) {
        return removable(envelope, fromInTooth, toInTooth, kDefaultClearance * lattice_.spacing());
    }
    /// Carries out a plan. Nothing was carved after the plan was made.
    CarveResult carve(const PlannedRemoval& removable);
    /// The same for the first part of that move, up to `end`. Reads only the nodes that the whole move reaches.
    /// Nothing was carved after `whole` was planned.
    [[nodiscard]] PlannedRemoval removableUpTo(const PlannedRemoval& whole, const RevolutionEnvelope& envelope,
                                               const Pose& fromInTooth, const Pose& end) const;

    /// Removes every detached piece (findDetachedPieces).
    DetachedPieces removeDetached();
    /// Removes the debris that has these nodes beside it in the air (nodesBesideDebris).
    CarveResult removeDebris(const NodeSets& beside);

    /// The next change begins a step of its own for `undo`.
    void mark() { journal_.mark(bricks_); }
    /// Number of steps that can be undone and redone (CutJournal). A change after an undo leaves nothing to redo.
    [[nodiscard]] std::size_t undoable() const { return journal_.undoable(); }
    [[nodiscard]] std::size_t redoable() const { return journal_.redoable(); }
    /// Restores the state before the last step, bit for bit. Returns the bricks that changed. There must be a step.
    std::vector<ChangedBrick> undo();
    /// Restores the state after the step that was undone last, bit for bit. Returns the bricks that changed. There must
    /// be such a step.
    std::vector<ChangedBrick> redo();
    /// Number of calls of `undo`, `redo` and `reset`. Between two of them the removed region only grows.
    [[nodiscard]] std::uint64_t restorations() const { return restorations_; }

    /// Number of changes of the removed region. As long as it is the same, equal moves remove the same.
    [[nodiscard]] std::uint64_t edits() const { return carves_; }

    /// Restores the whole tooth. The journal takes it for a change like any other.
    void reset();

    /// The bricks that a bur has reached, in ascending order of the keys.
    [[nodiscard]] std::vector<BrickKey> cutBricks() const;
    /// Takes over the removed region of another volume of the same spacing, or of a file. Nothing was cut here, and
    /// there is no step. Returns the bricks that changed. Bricks that are clear of this tooth are left out.
    std::vector<ChangedBrick> adopt(const std::map<BrickKey, CutField>& fields);
    /// Replaces the fields of these bricks by those that another volume of the same tooth and spacing has at another
    /// moment. Nothing can be undone or redone then. Returns the bricks that changed; those that are clear of this
    /// tooth are left out.
    std::vector<ChangedBrick> replace(const std::map<BrickKey, CutField>& fields);

    /// From now on `takeTouched` returns which bricks have changed.
    void noteTouched() { notesTouched_ = true; }
    /// The bricks whose fields may have changed since the last call, in ascending order of the keys.
    [[nodiscard]] std::vector<BrickKey> takeTouched();

    /// The volume removed so far, mm^3, summed again over all bricks.
    [[nodiscard]] MaterialVolumes removedVolume() const;
    /// FNV-1a over the fields of all cut bricks, in the order of the keys.
    [[nodiscard]] std::uint64_t hash() const;

    /// Signed distance of a point to the removed region, interpolated between the nodes, mm. Clamped to kCutBand
    /// voxels.
    [[nodiscard]] double cutDistance(const Vec3& point) const;

    [[nodiscard]] const BrickMap& bricks() const { return bricks_; }
    [[nodiscard]] const Lattice& lattice() const { return lattice_; }
    [[nodiscard]] const std::shared_ptr<const LayeredTooth>& tooth() const { return tooth_; }
    /// Asserts the invariants of the bricks, their neighbours, the journal and the pool. For tests: looks at every
    /// node.
    void validate() const;
    [[nodiscard]] std::size_t bytes() const { return bricks_.keys().size() * sizeof(Brick) + journal_.bytes(); }

private:
    [[nodiscard]] std::vector<Brick*> bricksAt(const std::vector<BrickKey>& keys);
    void makeBricks(std::vector<BrickKey> missing);
    void keep(const BrickKey& key);
    std::vector<ChangedBrick> setFields(const std::map<BrickKey, CutField>& fields);
    void makeAffected(const std::vector<ChangedBrick>& changed);
    [[nodiscard]] NodeSets nodesOf(const DetachedPiece& piece);
    CarveResult removePieces(const NodeSets& pieces);
    [[nodiscard]] std::vector<ChangedBrick> restore(const CutJournal::Fields& fields);
    [[nodiscard]] std::vector<ChangedBrick> updateHermiteData(const PlannedRemoval& carved);

    std::shared_ptr<const LayeredTooth> tooth_;
    Lattice lattice_;
    BrickMap bricks_;
    CutJournal journal_;
    std::shared_ptr<BrickPool> pool_;
    std::uint64_t carves_ = 0;
    std::uint64_t restorations_ = 0;
    bool notesTouched_ = false;
    std::vector<BrickKey> touched_;  // since the last takeTouched, with repetitions
};

}  // namespace tactooth
