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

/// The bricks of which a node may be less than `reach` (mm) from what is swept, as far as they can hold some of the
/// tooth; in ascending order of their keys.
[[nodiscard]] std::vector<BrickKey> bricksInReach(const LayeredTooth& tooth, const Lattice& lattice,
                                                  const std::vector<SweepStep>& steps, double reach);

/// Bricks made ahead of a bur on a thread of its own, so that a cut need not wait for them. What is in a brick depends
/// on the tooth alone: a cut is the same to the last bit with a stock and without.
class BrickPool {
public:
    BrickPool(std::shared_ptr<const LayeredTooth> tooth, double voxel) : tooth_(std::move(tooth)), lattice_(voxel) {
        TACTOOTH_ASSERT(tooth_ != nullptr);
    }

    /// Whether it makes the bricks of this tooth at this spacing, mm.
    [[nodiscard]] bool isFor(const std::shared_ptr<const LayeredTooth>& tooth, double voxel) const {
        return tooth_ == tooth && lattice_.spacing() == voxel;
    }

    /// Makes some of the bricks that a bur at this pose may come to soon, the nearest first. Returns how many: 0 once
    /// all are there. One thread.
    std::size_t makeAround(const RevolutionEnvelope& envelope, const Pose& toolInTooth);

    /// Another thread, the cutter's: hands over the bricks with these keys that were made (null: there is nothing of
    /// the tooth in it); nothing for those that were not. All of them count as taken from now on.
    [[nodiscard]] std::vector<std::optional<std::unique_ptr<Brick>>> take(const std::vector<BrickKey>& keys);

    /// What was taken is given up again, as the whole tooth is wanted anew.
    void forgetTaken();

    /// Asserts that no brick is made and taken at once, that the pool holds no more than it may, and the invariants of
    /// the bricks that it holds. Any thread; looks at every node.
    void validate();

private:
    [[nodiscard]] std::vector<BrickKey> wanted(const RevolutionEnvelope& envelope, const Pose& toolInTooth);

    const std::shared_ptr<const LayeredTooth> tooth_;
    const Lattice lattice_;
    std::mutex mutex_;  // of what follows
    std::unordered_map<BrickKey, std::unique_ptr<Brick>, BrickKeyHash> made_;
    std::unordered_set<BrickKey, BrickKeyHash> taken_;
};

}  // namespace tactooth
