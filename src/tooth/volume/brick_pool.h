// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "geometry/util/assert.h"
#include "tooth/model/layered_tooth.h"
#include "tooth/sweep/swept_envelope.h"
#include "tooth/volume/brick_map.h"

namespace tactooth {

/// The bricks that may hold a node within `reach` (mm) of the swept region and may hold some of the tooth, in ascending
/// order of their keys. `steps` is not empty.
[[nodiscard]] std::vector<BrickKey> bricksInReach(const LayeredTooth& tooth, const Lattice& lattice,
                                                  const std::vector<SweepStep>& steps, double reach);

/// Bricks that a thread of its own makes ahead of the bur, so that a cut need not wait for them. The contents of a
/// brick depend on the tooth alone, so that a cut is the same with a pool and without, bit for bit.
class BrickPool {
public:
    BrickPool(std::shared_ptr<const LayeredTooth> tooth, double voxel) : tooth_(std::move(tooth)), lattice_(voxel) {
        TACTOOTH_ASSERT(tooth_ != nullptr);
    }

    /// Whether the pool makes bricks of this tooth at this spacing, mm.
    [[nodiscard]] bool isFor(const std::shared_ptr<const LayeredTooth>& tooth, double voxel) const {
        return tooth_ == tooth && lattice_.spacing() == voxel;
    }

    /// Makes some of the bricks that a bur at this pose may reach soon, the nearest first. Returns their number, 0 when
    /// all exist. Called by one thread.
    std::size_t makeAround(const RevolutionEnvelope& envelope, const Pose& toolInTooth);

    /// Hands over the finished bricks with these keys; called by the carving thread. Null: the brick holds nothing of
    /// the tooth. No value: the brick is not finished. All keys count as taken from now on.
    [[nodiscard]] std::vector<std::optional<std::unique_ptr<Brick>>> take(const std::vector<BrickKey>& keys);

    /// Asserts that no brick is both made and taken, that the pool is within its capacity, and the invariants of its
    /// bricks. Any thread may call it. Looks at every node.
    void validate();

private:
    [[nodiscard]] std::vector<BrickKey> wanted(const RevolutionEnvelope& envelope, const Pose& toolInTooth);

    const std::shared_ptr<const LayeredTooth> tooth_;
    const Lattice lattice_;
    std::mutex mutex_;  // guards the following members
    std::unordered_map<BrickKey, std::unique_ptr<Brick>, BrickKeyHash> made_;
    std::unordered_set<BrickKey, BrickKeyHash> taken_;
};

}  // namespace tactooth
