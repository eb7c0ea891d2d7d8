// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/volume/remaining_fractions.h"

#include <algorithm>
#include <bit>

#include "collision/bvh/closest_point.h"
#include "geometry/util/assert.h"
#include "tooth/volume/brick_sampler.h"
#include "tooth/volume/voxel_fraction.h"

// Own method. Cubes of bricks are divided into eight, as in an octree, until one material fills a cube or a cube is a
// single brick.

namespace tactooth {
namespace {

/// Bricks along a side of the largest blocks: a quarter of a molar at 25 um.
constexpr int kLargestBlock = 32;

/// Voxels. Half the diagonal of a unit cube: a plane farther from a node does not cut its voxel.
constexpr double kVoxelReach = 0.8660254037844386;

double remainingFraction(const Brick& brick, int node, double spacing) {
    TACTOOTH_ASSERT(node >= 0 && node < kBrickNodes);
    const HalfSpace tooth{brick.tooth[node] / spacing, brick.toothNormal[node].unpack()};
    const HalfSpace left{-brick.cut[node] / spacing, -brick.cutNormal[node].unpack()};
    if (tooth.distance >= kVoxelReach || left.distance >= kVoxelReach) return 0;
    if (tooth.distance <= -kVoxelReach) return cubeFraction(left);
    return left.distance <= -kVoxelReach ? cubeFraction(tooth) : cubeFraction(tooth, left);
}

int roundedDown(int place, int step) {
    TACTOOTH_ASSERT(step > 0);
    return (place >= 0 ? place : place - step + 1) / step * step;
}

/// Whether a key lies in the cube of `side` bricks that begins at `first`.
bool isIn(const BrickKey& key, const BrickKey& first, int side) {
    const auto within = [&](int place, int low) { return place >= low && place < low + side; };
    return within(key.x, first.x) && within(key.y, first.y) && within(key.z, first.z);
}

}  // namespace

RemainingFractions::RemainingFractions(const CutVolume& volume) : volume_(volume) {
    const Lattice& lattice = volume.lattice();
    const Vec3 voxel = Vec3::Constant(lattice.spacing());
    const Box3& box = volume.tooth()->outer()->tree().box();
    const BrickKey low = lattice.brickAt(box.min() - voxel);
    const BrickKey high = lattice.brickAt(box.max() + voxel);
    const std::vector<BrickKey> cut = volume.cutBricks();
    constexpr int kStep = kLargestBlock;
    for (int x = roundedDown(low.x, kStep); x <= high.x; x += kStep) {
        for (int y = roundedDown(low.y, kStep); y <= high.y; y += kStep) {
            for (int z = roundedDown(low.z, kStep); z <= high.z; z += kStep) classify({x, y, z}, kStep, cut);
        }
    }
}

bool RemainingFractions::isUniform(const Vec3& centre, double reach) const {
    TACTOOTH_ASSERT(centre.allFinite() && reach > 0);
    const LayeredTooth& tooth = *volume_.tooth();
    return !closestPoint(*tooth.outer(), centre, reach) &&
           std::none_of(tooth.layers().begin(), tooth.layers().end(),
                        [&](const LayeredTooth::Layer& layer) { return closestPoint(*layer.part, centre, reach); });
}

/// The voxels of a block fill a cube around the middle of its nodes.
void RemainingFractions::classify(const BrickKey& first, int side, const std::vector<BrickKey>& cut) {
    TACTOOTH_ASSERT(side >= 1 && side <= kLargestBlock && std::has_single_bit(static_cast<unsigned>(side)));
    const Lattice& lattice = volume_.lattice();
    std::vector<BrickKey> cutHere;
    std::copy_if(cut.begin(), cut.end(), std::back_inserter(cutHere),
                 [&](const BrickKey& key) { return isIn(key, first, side); });
    const double nodes = side * kBrickSide;
    const Vec3 centre = lattice.corner(first) + Vec3::Constant(0.5 * (nodes - 1) * lattice.spacing());
    if (cutHere.empty() && isUniform(centre, kVoxelReach * nodes * lattice.spacing())) {
        if (contains(*volume_.tooth()->outer(), centre)) {
            blocks_.push_back({first, side, volume_.tooth()->materialAt(centre)});
        }
        return;
    }
    if (side == 1) {
        mixed_.push_back(first);
        return;
    }
    const int half = side / 2;
    for (int i = 0; i < 8; ++i) {
        classify(first.moved(half * (i & 1), half * (i >> 1 & 1), half * (i >> 2)), half, cutHere);
    }
}

BrickFractions RemainingFractions::fractionsOf(const BrickKey& key) const {
    BrickFractions shares(volume_.tooth()->materials().size());
    const double spacing = volume_.lattice().spacing();
    const Brick* brick = volume_.bricks().find(key);
    std::unique_ptr<Brick> made;
    if (brick == nullptr) {
        made = sampleBrick(*volume_.tooth(), volume_.lattice(), key);
        brick = made.get();
    }
    if (brick == nullptr) return shares;
    for (int node = 0; node < kBrickNodes; ++node) {
        const double share = remainingFraction(*brick, node, spacing);
        TACTOOTH_ASSERT(share >= 0 && share <= 1);
        const double beyond = share * brick->neighbourFraction[node] / 255;
        shares[static_cast<std::size_t>(brick->material[node])][node] += static_cast<float>(share - beyond);
        shares[static_cast<std::size_t>(brick->neighbour[node])][node] += static_cast<float>(beyond);
    }
    return shares;
}

}  // namespace tactooth
