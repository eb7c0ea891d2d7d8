// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0

// Seeded random sequences of all operations on a tooth: cutting, marks, undo, reset, removal of detached pieces, save
// and open. After each operation the volume and its surface validate their invariants.

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <random>

#include "support/expect_assert.h"
#include "support/materials.h"
#include "support/shapes.h"
#include "tooth/file/debris.h"
#include "tooth/surface/cavity_wall.h"
#include "tooth/surface/incremental_surface.h"
#include "tooth/volume/brick_sampler.h"
#include "tooth/volume/bur_feed.h"
#include "tooth/volume/cut_volume.h"

namespace tactooth {
namespace {

constexpr double kVoxel = 0.1;
constexpr int kSteps = 24;

std::shared_ptr<const LayeredTooth> ball() {
    return std::make_shared<const LayeredTooth>(
        std::move(*LayeredTooth::make(test::sphere(Vec3::Zero(), 1.5, 32, 16),
                                      {{"dentin", test::kDentin, test::sphere(Vec3::Zero(), 1.1, 32, 16)}})));
}

/// A volume with its surface, changed by random operations.
class Operated {
public:
    explicit Operated(unsigned seed) : random_(seed) { volume_.setPool(pool_); }

    void step() {
        switch (random_() % 10) {
            case 0:
                volume_.mark();
                break;
            case 1:
                if (volume_.undoable() > 0) update(volume_.undo());
                break;
            case 2:
                update(volume_.removeDetached().carve.changed);
                update(
                    volume_.removeDebris(nodesBesideDebris(*surface_.snapshot(), volume_.bricks(), volume_.lattice()))
                        .changed);
                break;
            case 3:
                if (random_() % 4 == 0) reset();
                if (volume_.redoable() > 0) update(volume_.redo());
                break;
            case 4:
                (void)pool_->makeAround(bur_, pose());
                break;
            case 5:
                update(feedBur(volume_, bur_, pose(), pose(), 2, {}, 1).carve.changed);
                break;
            default:
                update(volume_.carve(bur_, pose(), pose()).changed);
        }
    }

    void validate() const {
        volume_.validate();
        surface_.validate();
    }

    /// Saves and opens: a volume of the same tooth adopts the cut fields.
    void validateCopy() const {
        std::map<BrickKey, CutField> fields;
        for (const BrickKey& key : volume_.cutBricks()) fields[key] = *volume_.bricks().find(key);
        CutVolume copy(volume_.tooth(), kVoxel);
        IncrementalSurface surface(copy);
        surface.update(copy, copy.adopt(fields));
        copy.validate();
        surface.validate();
        EXPECT_EQ(copy.hash(), volume_.hash());
    }

    [[nodiscard]] const CutVolume& volume() const { return volume_; }

private:
    void update(const std::vector<ChangedBrick>& changed) { surface_.update(volume_, changed); }
    void reset() {
        volume_.reset();
        surface_.reset();
    }
    [[nodiscard]] double unit() { return std::uniform_real_distribution<double>(-1, 1)(random_); }
    [[nodiscard]] Pose pose() {
        const Vec3 axis = Vec3(unit(), unit(), 1.1 + unit()).normalized();
        return {1.3 * Vec3(unit(), unit(), unit()), Quat(Eigen::AngleAxisd(3 * unit(), axis))};
    }

    std::mt19937 random_;
    CutVolume volume_{ball(), kVoxel};
    IncrementalSurface surface_{volume_};
    std::shared_ptr<BrickPool> pool_ = std::make_shared<BrickPool>(volume_.tooth(), kVoxel);
    RevolutionEnvelope bur_ = *RevolutionEnvelope::make(test::cylinder(Vec3::Zero(), 0.25, 2, 32));
};

TEST(RandomOperations, KeepEachInvariantOfTheVolumeAndItsSurface) {
    std::size_t cut = 0;
    for (const unsigned seed : {1U, 2U, 3U, 4U}) {
        Operated tooth(seed);
        tooth.validate();
        for (int i = 0; i < kSteps; ++i) {
            SCOPED_TRACE("seed " + std::to_string(seed) + ", step " + std::to_string(i));
            tooth.step();
            tooth.validate();
        }
        tooth.validateCopy();
        tooth.volume().tooth()->validate();
        cut += tooth.volume().cutBricks().size();
    }
    EXPECT_GT(cut, 100U);
}

TEST(RandomOperations, ValidationFindsABrickThatWasChangedBehindTheVolumesBack) {
    const auto tooth = ball();
    const Lattice lattice(kVoxel);
    BrickMap bricks;
    for (const BrickKey& key : lattice.bricksTouching(tooth->outer()->tree().box()))
        bricks.insert(key, sampleBrick(*tooth, lattice, key));
    bricks.validate(kVoxel);
    bricks.find(bricks.keys().front())->cut[17] = -0.01F;
    EXPECT_ASSERT(bricks.validate(kVoxel));
}

TEST(RandomOperations, ValidationFindsAWallWithATriangleTooManyOrACornerThatIsNone) {
    CutVolume volume(ball(), kVoxel);
    const RevolutionEnvelope bur = *RevolutionEnvelope::make(test::cylinder(Vec3::Zero(), 0.5, 4, 32));
    const CarveResult cut = volume.carve(bur, {Vec3(0, 0, 2), Quat::Identity()}, {Vec3::Zero(), Quat::Identity()});
    std::size_t triangles = 0;
    for (const ChangedBrick& brick : cut.changed) {
        const BrickNeighbourhood nodes(volume.bricks(), brick.key, kVoxel);
        CavityWall wall = extractWall(nodes, volume.lattice(), brick.key);
        wall.validate();
        triangles += wall.mesh.triangles.size();
        if (wall.mesh.empty()) continue;
        CavityWall wrong = wall;
        wrong.mesh.triangles.push_back(wrong.mesh.triangles.front());
        EXPECT_ASSERT(wrong.validate());
        wall.mesh.triangles.front()[1] = static_cast<std::uint32_t>(wall.mesh.vertices.size());
        EXPECT_ASSERT(wall.validate());
    }
    EXPECT_GT(triangles, 100U);
}

TEST(RandomOperations, ASurfaceFollowsItsOwnVolumeOnly) {
    CutVolume volume(ball(), kVoxel);
    CutVolume other(ball(), kVoxel);
    IncrementalSurface surface(volume);
    EXPECT_ASSERT(surface.update(other, {}));
}

}  // namespace
}  // namespace tactooth
