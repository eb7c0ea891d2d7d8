// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "tooth/model/layered_tooth.h"
#include "tooth/sweep/revolution_envelope.h"
#include "tooth/sweep/swept_envelope.h"
#include "tooth/volume/brick_map.h"
#include "tooth/volume/brick_pool.h"
#include "tooth/volume/cut_journal.h"
#include "tooth/volume/detached_pieces.h"

namespace tactooth {

/// Volumes by MaterialId, mm^3; zero where the registry of the tooth has no material.
using MaterialVolumes = std::array<double, kMaxMaterials>;

[[nodiscard]] double total(const MaterialVolumes& volumes);

/// A brick in which a carve has moved the border of the removed region, and which bricks have a node in a cell that
/// this concerns.
struct ChangedBrick {
    BrickKey key;
    std::uint32_t affected = 0;  ///< bit i: BrickKey::neighbour(i)

    [[nodiscard]] static ChangedBrick all(const BrickKey& key) { return {key, (1U << 27) - 1}; }
    [[nodiscard]] bool isNone() const { return affected == 0; }
    /// A node was removed: all cells around it.
    void addNode(int node);
    /// The border was moved on the lattice edge from a node to the next one on `axis`: the four cells around that.
    void addEdge(int node, int axis);
    void add(const ChangedBrick& other) { affected |= other.affected; }

    /// Calls `visit(i)` for the bricks that are affected, by their numbers as neighbours.
    template <class Visit>
    void forEachAffected(const Visit& visit) const {
        for (std::uint32_t left = affected; left != 0; left &= left - 1) visit(std::countr_zero(left));
    }
};

/// One entry a brick that covers all changes of it, in ascending order of their keys; bricks without one are left out.
[[nodiscard]] std::vector<ChangedBrick> merged(std::vector<ChangedBrick> changes);

struct CarveResult {
    MaterialVolumes removed{};
    std::vector<ChangedBrick> changed;  ///< in ascending order of their keys
};

/// What a move of the bur would remove from one brick, and what the cut field would become.
struct BrickRemoval {
    struct Sample {
        std::uint16_t node;  ///< nodeIndex
        float distance;      ///< of the cut field, mm
        OctahedralNormal normal;
    };
    BrickKey key{};
    MaterialVolumes volumes{};
    std::vector<Sample> lowered;
};

/// What a move of the bur would remove, with all that is needed to remove it.
struct PlannedRemoval {
    MaterialVolumes volumes{};
    std::vector<BrickRemoval> where;  ///< in ascending order of the keys
    std::vector<SweepStep> steps;
    double clearance = 0;          ///< that it was asked with, mm
    std::uint64_t afterCarve = 0;  ///< it holds until the next one
};

/// Pieces that burs have cut off all around and that are no longer there.
struct DetachedPieces {
    std::vector<double> volumes;  ///< of each, mm^3, to a voxel or so at its surface
    CarveResult carve;            ///< what went with them
};

/// How much wider than the bur the cut is by default, in voxels: room for the chords of the extracted surface, so that
/// a bur at rest in its own cut does not touch it. A flat bur of 1 mm that mills a slot at 50 um: none is left in its
/// way at 0.1, 1.6 um at 0.04. Pass 0 where the removed volume itself is the question.
inline constexpr double kDefaultClearance = 0.1;

/// The part of a tooth that burs have removed, as a sparse volume of bricks which are made when a bur comes near.
/// One thread writes; the work inside is shared among the cores, and the result is the same for any number of them.
class CutVolume {
public:
    /// `voxel` is the spacing of the nodes, mm.
    CutVolume(std::shared_ptr<const LayeredTooth> tooth, double voxel);

    /// Where bricks are taken from that were made ahead, for the same tooth and spacing; null: each is made when it is
    /// needed. Changes no result.
    void setPool(std::shared_ptr<BrickPool> pool) { pool_ = std::move(pool); }

    /// Removes everything that `envelope`, dilated by `clearance` (mm), sweeps on its way between two poses of the tool
    /// in the tooth's frame. Volumes are counted below the voxel: to about 0.1 % of a cut some voxels wide.
    CarveResult carve(const RevolutionEnvelope& envelope, const Pose& fromInTooth, const Pose& toInTooth,
                      double clearance);
    CarveResult carve(const RevolutionEnvelope& envelope, const Pose& fromInTooth, const Pose& toInTooth) {
        return carve(envelope, fromInTooth, toInTooth, kDefaultClearance * lattice_.spacing());
    }

    /// What the same `carve` would remove. Changes nothing (bricks that are needed for the answer are kept). The
    /// envelope outlives the answer.
    [[nodiscard]] PlannedRemoval removable(const RevolutionEnvelope& envelope, const Pose& fromInTooth,
                                           const Pose& toInTooth, double clearance);
    [[nodiscard]] PlannedRemoval removable(const RevolutionEnvelope& envelope, const Pose& fromInTooth,
                                           const Pose& toInTooth) {
        return removable(envelope, fromInTooth, toInTooth, kDefaultClearance * lattice_.spacing());
    }
    /// Does it, unless something was carved meanwhile.
    CarveResult carve(const PlannedRemoval& removable);
    /// The same for the first part of that move, up to `partWay`: looks nowhere but at the nodes that the whole move
    /// reaches.
    [[nodiscard]] PlannedRemoval removablePartWay(const PlannedRemoval& whole, const RevolutionEnvelope& envelope,
                                                  const Pose& fromInTooth, const Pose& partWay) const;

    /// Removes every piece that hangs together with nothing any more (findDetachedPieces).
    DetachedPieces removeDetached();
    /// Removes the crumbs that have these nodes beside them in the air (nodesBesideDebris).
    CarveResult removeDebris(const NodeSets& beside);

    /// Sets a mark that `undo` goes back to; false if nothing has changed since the last one, which then serves.
    bool mark() { return journal_.mark(); }
    /// How many times `undo` can go back: as many as marks were set, and CutJournal::kMaxCheckpoints at most.
    [[nodiscard]] std::size_t marks() const { return journal_.marks(); }
    /// Everything as it was at the last mark that anything came after, bit for bit; forgets that mark. Returns the
    /// bricks that changed.
    std::vector<ChangedBrick> undo();
    /// How often `undo` was called: between two calls the removed region only grows.
    [[nodiscard]] std::uint64_t undos() const { return undos_; }

    /// The whole tooth again; no mark is left.
    void reset();

    /// The bricks that a bur has reached, in ascending order of their keys.
    [[nodiscard]] std::vector<BrickKey> cutBricks() const;
    /// Takes over the removed region of another volume of the same spacing, or from a file, brick by brick: nothing may
    /// have been cut here. Returns the bricks that changed. Bricks that lie clear of this tooth are left out.
    std::vector<ChangedBrick> adopt(const std::map<BrickKey, CutField>& fields);

    /// Everything removed so far, summed anew over all bricks.
    [[nodiscard]] MaterialVolumes removedVolume() const;
    /// FNV-1a over the fields of all bricks that were cut, in the order of their keys.
    [[nodiscard]] std::uint64_t hash() const;

    /// Distance from a point to the removed region, read between the nodes, mm; clamped to kCutBand voxels.
    [[nodiscard]] double cutDistance(const Vec3& point) const;

    [[nodiscard]] const BrickMap& bricks() const { return bricks_; }
    [[nodiscard]] const Lattice& lattice() const { return lattice_; }
    [[nodiscard]] const std::shared_ptr<const LayeredTooth>& tooth() const { return tooth_; }
    [[nodiscard]] std::size_t bytes() const { return bricks_.keys().size() * sizeof(Brick) + journal_.bytes(); }

private:
    [[nodiscard]] std::vector<Brick*> bricksAt(const std::vector<BrickKey>& keys);
    void makeBricks(std::vector<BrickKey> missing);
    void makeAffected(const std::vector<ChangedBrick>& changed);
    [[nodiscard]] NodeSets nodesOf(const DetachedPiece& piece);
    CarveResult removePieces(const NodeSets& pieces);
    [[nodiscard]] std::vector<ChangedBrick> updateHermiteData(const PlannedRemoval& carved);

    std::shared_ptr<const LayeredTooth> tooth_;
    Lattice lattice_;
    BrickMap bricks_;
    CutJournal journal_;
    std::shared_ptr<BrickPool> pool_;
    std::uint64_t carves_ = 0;
    std::uint64_t undos_ = 0;
};

}  // namespace tactooth
