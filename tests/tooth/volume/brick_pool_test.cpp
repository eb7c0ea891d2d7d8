// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/volume/brick_pool.h"

#include <gtest/gtest.h>

#include <thread>

#include "support/expect_assert.h"
#include "support/materials.h"
#include "support/shapes.h"
#include "tooth/volume/cut_volume.h"

namespace tactooth {
namespace {

constexpr double kVoxel = 0.05;

std::shared_ptr<const LayeredTooth> ball() {
    return std::make_shared<const LayeredTooth>(std::move(*LayeredTooth::make(
        test::sphere(Vec3::Zero(), 3, 48, 24), {{"dentin", test::kDentin, test::sphere(Vec3::Zero(), 2.4, 48, 24)}})));
}

RevolutionEnvelope bur() { return *RevolutionEnvelope::make(test::sphere(Vec3(0, 0, 0.4), 0.4, 48, 24)); }

/// Down into the ball and to the side.
Pose onTheWay(int i) {
    const double down = std::min(0.05 * i, 1.5);
    return {Vec3(std::max(0.0, 0.05 * i - 1.5), 0.1, 3.1 - down), Quat::Identity()};
}
constexpr int kMoves = 50;

std::uint64_t hashOfCut(CutVolume& volume) {
    const RevolutionEnvelope tool = bur();
    for (int i = 0; i < kMoves; ++i) volume.carve(tool, onTheWay(i), onTheWay(i + 1));
    return volume.hash();
}

std::uint64_t hashWithoutPool() {
    CutVolume volume(ball(), kVoxel);
    return hashOfCut(volume);
}

/// A volume that takes its bricks from a pool.
struct Supplied {
    CutVolume volume{ball(), kVoxel};
    std::shared_ptr<BrickPool> pool = std::make_shared<BrickPool>(volume.tooth(), kVoxel);
    Supplied() { volume.setPool(pool); }
};

void fill(BrickPool& pool, const Pose& at) {
    const RevolutionEnvelope tool = bur();
    while (pool.makeAround(tool, at) > 0) {
    }
}

TEST(BrickPool, ACutIsTheSameWithItAndWithout) {
    Supplied with;
    fill(*with.pool, onTheWay(0));
    EXPECT_EQ(hashOfCut(with.volume), hashWithoutPool());
}

TEST(BrickPool, HasWhatTheBurComesToNext) {
    const auto tooth = ball();
    BrickPool pool(tooth, kVoxel);
    fill(pool, onTheWay(30));
    const Lattice lattice(kVoxel);
    const RevolutionEnvelope tool = bur();
    const std::vector<SweepStep> move = {SweepStep(tool, onTheWay(30), onTheWay(33), 0)};
    const std::vector<BrickKey> keys = bricksInReach(*tooth, lattice, move, kVoxel);
    ASSERT_GT(keys.size(), 20U);
    int bricks = 0;
    for (const auto& brick : pool.take(keys)) {
        ASSERT_TRUE(brick.has_value());
        bricks += *brick != nullptr;
    }
    EXPECT_GT(bricks, 20);
}

TEST(BrickPool, MakesNoTakenBrickAgain) {
    const auto tooth = ball();
    BrickPool pool(tooth, kVoxel);
    const RevolutionEnvelope tool = bur();
    const std::vector<SweepStep> here = {SweepStep(tool, onTheWay(30), onTheWay(30), 0)};
    const std::vector<BrickKey> all = bricksInReach(*tooth, Lattice(kVoxel), here, 2);
    for (const auto& brick : pool.take(all)) EXPECT_FALSE(brick.has_value());
    EXPECT_EQ(pool.makeAround(tool, onTheWay(30)), 0U);
}

TEST(BrickPool, AVolumeThatIsResetIsCutAgainAlike) {
    Supplied again;
    const std::uint64_t first = hashOfCut(again.volume);
    again.volume.reset();
    EXPECT_EQ(hashOfCut(again.volume), first);
}

TEST(BrickPool, AThreadMayFillItWhileAnotherCuts) {
    Supplied with;
    const std::jthread maker([&](const std::stop_token& stop) {
        for (int i = 0; i <= kMoves && !stop.stop_requested(); ++i) fill(*with.pool, onTheWay(i));
    });
    EXPECT_EQ(hashOfCut(with.volume), hashWithoutPool());
}

TEST(BrickPoolAsserts, TheToothIsGivenAndASweepHasSteps) {
    EXPECT_ASSERT(BrickPool(nullptr, kVoxel));
    EXPECT_ASSERT(static_cast<void>(bricksInReach(*ball(), Lattice(kVoxel), {}, kVoxel)));
}

TEST(BrickPoolAsserts, AVolumeTakesNoPoolOfAnotherToothOrSpacing) {
    CutVolume volume(ball(), kVoxel);
    EXPECT_ASSERT(volume.setPool(std::make_shared<BrickPool>(ball(), kVoxel)));
    EXPECT_ASSERT(volume.setPool(std::make_shared<BrickPool>(volume.tooth(), 2 * kVoxel)));
}

}  // namespace
}  // namespace tactooth
