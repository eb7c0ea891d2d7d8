// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/volume/cut_volume.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>
#include <utility>

#include "geometry/util/assert.h"
#include "geometry/util/fnv1a.h"
#include "geometry/util/parallel_for.h"
#include "tooth/volume/brick_carver.h"
#include "tooth/volume/brick_sampler.h"
#include "tooth/volume/hermite_data.h"
#include "tooth/volume/piece_remover.h"

namespace tactooth {
namespace {

/// Voxels. Longest step of a sweep: within one step the distance to a bur counts as convex along the path.
constexpr double kLongestStep = 1.0;

MaterialVolumes sum(const std::vector<MaterialVolumes>& parts) {
    MaterialVolumes volumes{};
    for (const MaterialVolumes& part : parts) {
        for (std::size_t i = 0; i < kMaxMaterials; ++i) volumes[i] += part[i];
    }
    return volumes;
}

void gather(std::vector<BrickRemoval>& parts, PlannedRemoval& result) {
    for (BrickRemoval& part : parts) {
        for (std::size_t m = 0; m < kMaxMaterials; ++m) result.volumes[m] += part.volumes[m];
        if (!part.lowered.empty()) result.where.push_back(std::move(part));
    }
}

}  // namespace

CutVolume::CutVolume(std::shared_ptr<const LayeredTooth> tooth, double voxel)
    : tooth_(std::move(tooth)), lattice_(voxel), journal_(voxel) {
    TACTOOTH_ASSERT(tooth_ != nullptr);
}

void CutVolume::reset() {
    ++carves_;  // plans made before are invalid
    ++restorations_;
    const CutField untouched = CutField::untouched(lattice_.spacing());
    for (const BrickKey& key : cutBricks()) {
        keep(key);
        bricks_.find(key)->setField(untouched);
    }
}

std::vector<BrickKey> CutVolume::takeTouched() {
    std::sort(touched_.begin(), touched_.end());
    touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
    return std::exchange(touched_, {});
}

/// Before a brick changes.
void CutVolume::keep(const BrickKey& key) {
    TACTOOTH_ASSERT(bricks_.find(key) != nullptr);
    journal_.keep(key, *bricks_.find(key));
    if (notesTouched_) touched_.push_back(key);
}

/// Returns the bricks at these keys and makes those that are still unknown. Null where a brick is clear of the tooth.
std::vector<Brick*> CutVolume::bricksAt(const std::vector<BrickKey>& keys) {
    std::vector<Brick*> bricks;
    bricks.reserve(keys.size());
    std::vector<BrickKey> missing;
    for (const BrickKey& key : keys) {
        const std::optional<Brick*> known = bricks_.known(key);
        if (!known) missing.push_back(key);
        bricks.push_back(known.value_or(nullptr));
    }
    if (missing.empty()) return bricks;
    makeBricks(std::move(missing));
    std::ranges::transform(keys, bricks.begin(), [&](const BrickKey& key) { return bricks_.find(key); });
    return bricks;
}

void CutVolume::makeBricks(std::vector<BrickKey> missing) {
    if (pool_ != nullptr) {
        std::vector<std::optional<std::unique_ptr<Brick>>> ahead = pool_->take(missing);
        TACTOOTH_ASSERT(ahead.size() == missing.size());
        std::size_t left = 0;
        for (std::size_t i = 0; i < missing.size(); ++i) {
            if (ahead[i]) {
                bricks_.insert(missing[i], std::move(*ahead[i]));
            } else {
                missing[left++] = missing[i];
            }
        }
        missing.resize(left);
    }
    std::vector<std::unique_ptr<Brick>> made(missing.size());
    parallelFor(missing.size(), [&](std::size_t i) { made[i] = sampleBrick(*tooth_, lattice_, missing[i]); });
    for (std::size_t i = 0; i < missing.size(); ++i) bricks_.insert(missing[i], std::move(made[i]));
}

/// The wall in a cell needs all eight nodes of the cell. The farthest may lie in a brick that no bur was near.
void CutVolume::makeAffected(const std::vector<ChangedBrick>& changed) {
    std::vector<BrickKey> missing;
    for (const ChangedBrick& brick : changed) {
        TACTOOTH_ASSERT(bricks_.find(brick.key) != nullptr);
        const BrickMap::Around& around = bricks_.around(brick.key);
        brick.forEachAffected([&](int i) {
            if (around[i] != nullptr) return;
            const BrickKey key = brick.key.neighbour(i);
            if (!bricks_.knows(key)) missing.push_back(key);
        });
    }
    if (missing.empty()) return;
    std::sort(missing.begin(), missing.end());
    missing.erase(std::unique(missing.begin(), missing.end()), missing.end());
    makeBricks(std::move(missing));
}

CarveResult CutVolume::carve(const RevolutionEnvelope& envelope, const Pose& fromInTooth, const Pose& toInTooth,
                             double clearance) {
    return carve(removable(envelope, fromInTooth, toInTooth, clearance));
}

CarveResult CutVolume::carve(const PlannedRemoval& removable) {
    TACTOOTH_ASSERT(removable.afterCarve == carves_);
    ++carves_;
    for (const BrickRemoval& found : removable.where) keep(found.key);
    std::vector<ChangedBrick> opened(removable.where.size());
    parallelFor(opened.size(), [&](std::size_t i) {
        const BrickRemoval& found = removable.where[i];
        opened[i] = carveBrick(*bricks_.find(found.key), found, carves_);
    });
    CarveResult result;
    result.removed = removable.volumes;
    result.changed = updateHermiteData(removable);
    result.changed.insert(result.changed.end(), opened.begin(), opened.end());
    result.changed = merged(std::move(result.changed));
    makeAffected(result.changed);
    return result;
}

/// Lattice edges that end in a changed brick belong to it or to the brick before it on an axis.
std::vector<ChangedBrick> CutVolume::updateHermiteData(const PlannedRemoval& carved) {
    std::vector<BrickKey> keys;
    for (const BrickRemoval& brick : carved.where) {
        const BrickKey& key = brick.key;
        for (const BrickKey& owner : {key, key.moved(-1, 0, 0), key.moved(0, -1, 0), key.moved(0, 0, -1)}) {
            if (bricks_.find(owner) != nullptr) keys.push_back(owner);
        }
    }
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    for (const BrickKey& key : keys) keep(key);
    std::vector<ChangedBrick> moved(keys.size());
    parallelFor(keys.size(), [&](std::size_t i) {
        moved[i] = updateHermiteInBrick(bricks_, keys[i], lattice_, carved.steps, carves_);
    });
    return moved;
}

PlannedRemoval CutVolume::removable(const RevolutionEnvelope& envelope, const Pose& fromInTooth, const Pose& toInTooth,
                                    double clearance) {
    TACTOOTH_ASSERT(std::isfinite(clearance) && clearance >= 0);
    PlannedRemoval result;
    result.clearance = clearance;
    result.afterCarve = carves_;
    result.steps = sweepSteps(envelope, fromInTooth, toInTooth, clearance, kLongestStep * lattice_.spacing());
    const std::vector<BrickKey> keys = bricksInReach(*tooth_, lattice_, result.steps, kCutBand * lattice_.spacing());
    const std::vector<Brick*> bricks = bricksAt(keys);
    std::vector<BrickRemoval> parts(keys.size());
    parallelFor(keys.size(), [&](std::size_t i) {
        if (bricks[i] != nullptr) parts[i] = removableFromBrick(*bricks[i], keys[i], lattice_, result.steps);
    });
    gather(parts, result);
    return result;
}

PlannedRemoval CutVolume::removableUpTo(const PlannedRemoval& whole, const RevolutionEnvelope& envelope,
                                        const Pose& fromInTooth, const Pose& end) const {
    TACTOOTH_ASSERT(whole.afterCarve == carves_);
    PlannedRemoval result;
    result.clearance = whole.clearance;
    result.afterCarve = whole.afterCarve;
    result.steps = sweepSteps(envelope, fromInTooth, end, whole.clearance, kLongestStep * lattice_.spacing());
    std::vector<BrickRemoval> parts(whole.where.size());
    parallelFor(parts.size(), [&](std::size_t i) {
        parts[i] = removableFromNodes(*bricks_.find(whole.where[i].key), whole.where[i], lattice_, result.steps);
    });
    gather(parts, result);
    return result;
}

/// The nodes of a piece. Makes its unsampled bricks.
NodeSets CutVolume::nodesOf(const DetachedPiece& piece) {
    NodeSets nodes = piece.nodes;
    const std::vector<Brick*> bricks = bricksAt(piece.unsampled);
    for (std::size_t i = 0; i < bricks.size(); ++i) {
        if (bricks[i] != nullptr) nodes[piece.unsampled[i]] = solidNodes(*bricks[i]);
    }
    return nodes;
}

DetachedPieces CutVolume::removeDetached() {
    DetachedPieces detached;
    NodeSets all;
    for (const DetachedPiece& piece : findDetachedPieces(bricks_, *tooth_, lattice_)) {
        std::size_t count = 0;
        for (const auto& [key, nodes] : nodesOf(piece)) {
            all[key] |= nodes;  // two pieces may share a brick
            count += nodes.count();
        }
        detached.volumes.push_back(static_cast<double>(count) * std::pow(lattice_.spacing(), 3));
    }
    detached.carve = removePieces(all);
    return detached;
}

CarveResult CutVolume::removeDebris(const NodeSets& beside) { return removePieces(beside); }

CarveResult CutVolume::removePieces(const NodeSets& pieces) {
    CarveResult result;
    if (pieces.empty()) return result;
    ++carves_;  // plans made before are invalid
    std::set<BrickKey> near;
    for (const auto& [key, nodes] : pieces) {
        for (int i = 0; i < 27; ++i) near.insert(key.neighbour(i));
    }
    (void)bricksAt({near.begin(), near.end()});
    const NodeSets gone = nodesToRemove(bricks_, pieces);
    TACTOOTH_ASSERT(gone.size() >= pieces.size());
    const auto isTouched = [&](const BrickKey& key) {  // the brick itself, or the far end of an edge that it owns
        const auto hasSome = [&](const BrickKey& at) { return gone.contains(at) && gone.at(at).any(); };
        return hasSome(key) || hasSome(key.moved(1, 0, 0)) || hasSome(key.moved(0, 1, 0)) ||
               hasSome(key.moved(0, 0, 1));
    };
    for (const auto& [key, nodes] : gone) {
        if (bricks_.find(key) == nullptr || !isTouched(key)) continue;
        Brick& brick = *bricks_.find(key);
        keep(key);
        const MaterialVolumes taken = nodes.any() ? removeNodes(brick, nodes, lattice_.spacing()) : MaterialVolumes{};
        for (std::size_t m = 0; m < kMaxMaterials; ++m) result.removed[m] += taken[m];
        result.changed.push_back(ChangedBrick::all(key));
    }
    for (const ChangedBrick& changed : result.changed) placeBoundary(bricks_, changed.key, gone);
    return result;
}

std::vector<ChangedBrick> CutVolume::undo() {
    TACTOOTH_ASSERT(undoable() > 0);
    return restore(journal_.undo(bricks_));
}

std::vector<ChangedBrick> CutVolume::redo() {
    TACTOOTH_ASSERT(redoable() > 0);
    return restore(journal_.redo(bricks_));
}

std::vector<ChangedBrick> CutVolume::restore(const CutJournal::Fields& fields) {
    std::vector<ChangedBrick> changed;
    ++carves_;  // plans made before are invalid
    ++restorations_;
    for (const auto& [key, field] : fields) {
        bricks_.find(key)->setField(field);
        if (notesTouched_) touched_.push_back(key);
        changed.push_back(ChangedBrick::all(key));
    }
    return changed;
}

std::vector<BrickKey> CutVolume::cutBricks() const {
    std::vector<BrickKey> keys = bricks_.keys();
    std::erase_if(keys, [&](const BrickKey& key) { return !bricks_.find(key)->isCut; });
    return keys;
}

std::vector<ChangedBrick> CutVolume::adopt(const std::map<BrickKey, CutField>& fields) {
    TACTOOTH_ASSERT(cutBricks().empty());
    TACTOOTH_ASSERT(undoable() == 0);
    return setFields(fields);
}

std::vector<ChangedBrick> CutVolume::replace(const std::map<BrickKey, CutField>& fields) {
    ++carves_;        // plans made before are invalid
    ++restorations_;  // the removed region may shrink
    journal_ = CutJournal(lattice_.spacing());
    return setFields(fields);
}

std::vector<ChangedBrick> CutVolume::setFields(const std::map<BrickKey, CutField>& fields) {
    std::vector<BrickKey> keys;
    for (const auto& [key, field] : fields) keys.push_back(key);
    const std::vector<Brick*> bricks = bricksAt(keys);
    std::vector<ChangedBrick> changed;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (bricks[i] == nullptr) continue;
        bricks[i]->setField(fields.at(keys[i]));
        if (notesTouched_) touched_.push_back(keys[i]);
        changed.push_back(ChangedBrick::all(keys[i]));
    }
    makeAffected(changed);
    return changed;
}

MaterialVolumes CutVolume::removedVolume() const {
    std::vector<MaterialVolumes> parts;
    for (const BrickKey& key : bricks_.keys()) {
        const Brick& brick = *bricks_.find(key);
        if (brick.isCut) parts.push_back(removedFromBrick(brick, lattice_.spacing()));
    }
    return sum(parts);
}

double CutVolume::cutDistance(const Vec3& point) const {
    TACTOOTH_ASSERT(point.allFinite());
    const Vec3 place = (point - lattice_.node(0, 0, 0)) / lattice_.spacing();
    const Vec3 first = place.array().floor();
    const Vec3 share = place - first;
    BrickKey lastKey{};
    const Brick* brick = nullptr;
    double distance = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3i step(corner & 1, corner >> 1 & 1, corner >> 2);
        const auto [key, node] = LatticeNode(first.cast<int>() + step);
        if (corner == 0 || key != lastKey) brick = bricks_.find(key);
        lastKey = key;
        double weight = 1;
        for (int axis = 0; axis < 3; ++axis) weight *= step[axis] == 1 ? share[axis] : 1 - share[axis];
        distance += weight * (brick != nullptr ? brick->cut[node] : kCutBand * lattice_.spacing());
    }
    TACTOOTH_ASSERT(std::abs(distance) <= kCutBand * lattice_.spacing() * (1 + 1e-6));
    return distance;
}

void CutVolume::validate() const {
    bricks_.validate(lattice_.spacing());
    journal_.validate(bricks_);
    if (pool_ != nullptr) pool_->validate();
    for (const BrickKey& key : bricks_.keys()) {
        const Brick& brick = *bricks_.find(key);
        TACTOOTH_ASSERT(brick.lastCarve <= carves_);
        for (int node = 0; node < kBrickNodes && brick.lastCarve == carves_; ++node) {
            TACTOOTH_ASSERT(!brick.opened[node] || brick.removed[node]);
        }
    }
}

std::uint64_t CutVolume::hash() const {
    Fnv1a hash;
    for (const BrickKey& key : bricks_.keys()) {
        const Brick& brick = *bricks_.find(key);
        if (!brick.isCut) continue;
        for (const int place : {key.x, key.y, key.z}) hash.addBytesOf(static_cast<std::uint32_t>(place));
        for (int node = 0; node < kBrickNodes; ++node) {
            hash.addBytesOf(std::uint64_t{std::bit_cast<std::uint32_t>(brick.cut[node])} << 32 |
                            std::bit_cast<std::uint32_t>(brick.cutNormal[node]));
            hash.addBytesOf(std::uint64_t{std::bit_cast<std::uint32_t>(brick.tooth[node])} << 8 |
                            static_cast<std::uint64_t>(brick.material[node]));
            for (const auto& crossings : brick.boundary) {
                hash.addBytesOf(std::uint64_t{std::bit_cast<std::uint32_t>(crossings[node].place)} << 32 |
                                std::bit_cast<std::uint32_t>(crossings[node].normal));
            }
        }
    }
    return hash.value();
}

}  // namespace tactooth
