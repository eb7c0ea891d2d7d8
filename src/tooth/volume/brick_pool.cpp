// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/volume/brick_pool.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/util/assert.h"
#include "tooth/volume/brick_sampler.h"

namespace tactooth {
namespace {

constexpr double kPrefetchReach = 12;      // voxels; at 25 um a bur at 10 mm/s needs 30 ms for this
constexpr std::size_t kBatch = 16;         // bricks, less than a millisecond; then the bur's pose is read again
constexpr std::size_t kMaxSampled = 4096;  // bricks, 90 MB; beyond this, bricks behind the bur are dropped

}  // namespace

std::vector<BrickKey> bricksInReach(const LayeredTooth& tooth, const Lattice& lattice,
                                    const std::vector<SweepStep>& steps, double reach) {
    TACTOOTH_ASSERT(!steps.empty());
    TACTOOTH_ASSERT(std::isfinite(reach) && reach >= 0);
    const double toCentre = lattice.halfDiagonal() + reach;
    const Vec3 toothMargin = Vec3::Constant(kToothBand * lattice.spacing());
    Box3 swept;
    for (const SweepStep& step : steps) swept.extend(step.box());
    const Box3& outer = tooth.outer()->tree().box();
    const Box3 common = Box3(swept.min() - Vec3::Constant(reach), swept.max() + Vec3::Constant(reach))
                            .intersection(Box3(outer.min() - toothMargin, outer.max() + toothMargin));
    if (common.isEmpty()) return {};
    double earlier = 0;  // travel before the last step, mm: one query at the last step excludes most bricks
    for (std::size_t i = 0; i + 1 < steps.size(); ++i) earlier += steps[i].travel();
    std::vector<BrickKey> keys = lattice.bricksTouching(common);
    std::erase_if(keys, [&](const BrickKey& key) {
        const Vec3 centre = lattice.centre(key);
        if (steps.back().lowerBound(centre) - earlier >= toCentre) return true;
        const auto isFar = [&](const SweepStep& step) { return step.lowerBound(centre) >= toCentre; };
        return steps.size() > 1 && std::ranges::all_of(steps, isFar);
    });
    return keys;
}

/// The nearest bricks that are neither made nor taken, at most kBatch.
std::vector<BrickKey> BrickPool::wanted(const RevolutionEnvelope& envelope, const Pose& toolInTooth) {
    const std::vector<SweepStep> here = {SweepStep(envelope, toolInTooth, toolInTooth, 0)};
    std::vector<BrickKey> keys =
        bricksInReach(*tooth_, lattice_, here, (kCutBand + kPrefetchReach) * lattice_.spacing());
    {
        const std::lock_guard lock(mutex_);
        if (made_.size() >= kMaxSampled) {
            std::erase_if(made_, [&](const auto& made) { return !std::ranges::binary_search(keys, made.first); });
        }
        if (made_.size() >= kMaxSampled) return {};
        std::erase_if(keys, [&](const BrickKey& key) { return made_.contains(key) || taken_.contains(key); });
    }
    std::vector<std::pair<double, BrickKey>> byDistance;
    for (const BrickKey& key : keys) byDistance.emplace_back(here.front().lowerBound(lattice_.centre(key)), key);
    const std::size_t count = std::min(kBatch, keys.size());
    std::partial_sort(byDistance.begin(), byDistance.begin() + static_cast<std::ptrdiff_t>(count), byDistance.end());
    keys.resize(count);
    for (std::size_t i = 0; i < count; ++i) keys[i] = byDistance[i].second;
    TACTOOTH_ASSERT(keys.size() <= kBatch);
    return keys;
}

std::size_t BrickPool::makeAround(const RevolutionEnvelope& envelope, const Pose& toolInTooth) {
    const std::vector<BrickKey> keys = wanted(envelope, toolInTooth);
    for (const BrickKey& key : keys) {
        std::unique_ptr<Brick> brick = sampleBrick(*tooth_, lattice_, key);
        const std::lock_guard lock(mutex_);
        if (!taken_.contains(key)) made_.insert_or_assign(key, std::move(brick));
        TACTOOTH_ASSERT(made_.size() < kMaxSampled + kBatch);
    }
    return keys.size();
}

std::vector<std::optional<std::unique_ptr<Brick>>> BrickPool::take(const std::vector<BrickKey>& keys) {
    std::vector<std::optional<std::unique_ptr<Brick>>> bricks(keys.size());
    const std::lock_guard lock(mutex_);
    for (std::size_t i = 0; i < keys.size(); ++i) {
        taken_.insert(keys[i]);
        const auto made = made_.find(keys[i]);
        if (made == made_.end()) continue;
        bricks[i] = std::move(made->second);
        made_.erase(made);
    }
    return bricks;
}

void BrickPool::validate() {
    const std::lock_guard lock(mutex_);
    TACTOOTH_ASSERT(made_.size() < kMaxSampled + kBatch);
    for (const auto& [key, brick] : made_) {
        TACTOOTH_ASSERT(key.isInRange());
        TACTOOTH_ASSERT(!taken_.contains(key));
        if (brick == nullptr) continue;
        TACTOOTH_ASSERT(!brick->isCut);
        brick->validate(lattice_.spacing());
    }
}

}  // namespace tactooth
