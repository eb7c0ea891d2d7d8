// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/volume/brick_carver.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

#include "collision/narrow/lane_flags.h"
#include "geometry/util/assert.h"
#include "tooth/volume/brick_sweep.h"
#include "tooth/volume/voxel_fraction.h"

// Own method. A sweep lowers the cut field of a node to its signed distance to the swept steps if that is smaller (a
// union of regions). The removed volume is the change of the volume fractions of the nodes' voxels
// (voxel_fraction.cpp), which counts below the size of a voxel. Eight nodes are processed at a time.

namespace tactooth {
namespace {

/// mm. A smaller change of the cut field is rounding at a wall that a bur passes along.
constexpr float kLeastChange = 2e-5F;

/// mm. A node that lies no deeper in the swept region stays solid. On a wall through nodes the sign is only rounding:
/// each node would decide for itself, and pockets too shallow for a float would fold the wall. The value is the error
/// of an envelope's distance to a sweep, and ten steps of a float at 10 mm.
constexpr float kLeastDepth = 1e-5F;

/// Voxels. Half the diagonal of a unit cube: a plane farther from a node does not cut its voxel.
constexpr double kVoxelReach = 0.8660254037844386;

/// Usual upper limit of the nodes of a brick that a move lowers.
constexpr std::size_t kUsuallyLowered = 256;

using CutSample = BrickRemoval::Sample;

// Eight nodes side by side: (x, y) = (0..3, y..y+1).
constexpr float kLaneX[8] = {0, 1, 2, 3, 0, 1, 2, 3};
constexpr float kLaneY[8] = {0, 0, 0, 0, 1, 1, 1, 1};
constexpr int kLaneNode[8] = {0, 1, 2, 3, kBrickSide, kBrickSide + 1, kBrickSide + 2, kBrickSide + 3};

float highestCut(const Brick& brick, int block) {
    Eigen::Array4f highest = Eigen::Array4f::Constant(-std::numeric_limits<float>::infinity());
    for (int i = 0; i < kBlockNodes; i += kBlockSide) {
        highest = highest.max(Eigen::Map<const Eigen::Array4f>(&brick.cut[nodeOfBlock(block, i)]));
    }
    return std::max(std::max(highest[0], highest[1]), std::max(highest[2], highest[3]));
}

/// The volume fractions of nodes' voxels that lie in the tooth and in the removed region. Most voxels are cut by no
/// boundary, or only by that of the removed region. These are computed four at a time.
class RemovedFractions {
public:
    RemovedFractions(const Brick& brick, double spacing)
        : brick_(brick), spacing_(spacing), reach_(kVoxelReach * spacing) {}

    /// Writes the fraction of a sample's voxel into `share`, at the latest in `finish`.
    void find(std::uint16_t node, float cut, OctahedralNormal normal, double& share) {
        TACTOOTH_ASSERT(node < kBrickNodes);
        TACTOOTH_ASSERT(!std::isnan(cut));
        const float tooth = brick_.tooth[node];
        share = 0;
        if (cut >= reach_ || tooth >= reach_) return;
        if (tooth > -reach_) {
            share =
                cubeFraction({cut / spacing_, normal.unpack()}, {tooth / spacing_, brick_.toothNormal[node].unpack()});
        } else if (cut <= -reach_) {
            share = 1;
        } else {
            distances_[count_] = cut / spacing_;
            normals_[count_] = normal;
            shares_[count_] = &share;
            if (++count_ == 4) finish();
        }
    }
    /// Computes the fractions that are still waiting.
    void finish() {
        const Eigen::Array4d found = cubeFractions(distances_, OctahedralNormal::absComponentsOf(normals_));
        TACTOOTH_ASSERT(count_ <= 4 && (found >= 0).all());
        for (int i = 0; i < count_; ++i) *shares_[i] = found[i];
        count_ = 0;
    }

private:
    const Brick& brick_;
    double spacing_;
    double reach_;  // mm
    int count_ = 0;
    Eigen::Array4d distances_ = Eigen::Array4d::Zero();
    std::array<OctahedralNormal, 4> normals_{};
    std::array<double*, 4> shares_{};
};

/// Adds a share of a node's voxel to the volumes of its materials.
void addShare(const Brick& brick, std::uint16_t node, double share, double spacing, MaterialVolumes& volumes) {
    TACTOOTH_ASSERT(std::abs(share) <= 1);
    const double volume = share * spacing * spacing * spacing;
    double& mine = volumes[static_cast<std::size_t>(brick.material[node])];
    if (brick.neighbourFraction[node] == 0) {
        mine += volume;
        return;
    }
    const double beyond = volume * brick.neighbourFraction[node] / 255;
    mine += volume - beyond;
    volumes[static_cast<std::size_t>(brick.neighbour[node])] += beyond;
}

/// Finds what is gone of the voxels of these nodes.
void findGone(const Brick& brick, std::span<CutSample> lowered, double spacing) {
    RemovedFractions shares(brick, spacing);
    for (CutSample& each : lowered) shares.find(each.node, brick.cut[each.node], brick.cutNormal[each.node], each.gone);
    shares.finish();
}

/// The volumes that lowering the cut field of these nodes removes.
MaterialVolumes volumesOf(const Brick& brick, std::span<const CutSample> lowered, double spacing) {
    TACTOOTH_ASSERT(lowered.size() <= kBrickNodes);
    std::array<double, kBrickNodes> after;
    RemovedFractions shares(brick, spacing);
    for (std::size_t i = 0; i < lowered.size(); ++i)
        shares.find(lowered[i].node, lowered[i].distance, lowered[i].normal, after[i]);
    shares.finish();
    MaterialVolumes volumes{};
    for (std::size_t i = 0; i < lowered.size(); ++i) {
        addShare(brick, lowered[i].node, after[i] - lowered[i].gone, spacing, volumes);
    }
    return volumes;
}

/// Eight nodes of one block, and the values to which a sweep lowers their cut field.
class LoweredNodes8 {
public:
    /// Nodes 8 `eight` .. 8 `eight` + 7 of a block. A step lowers a node if its distance is less than the node's value
    /// and less than `band` (mm). A node with the value -`band` cannot be lowered.
    LoweredNodes8(const Brick& brick, int block, int eight, float band) {
        TACTOOTH_ASSERT(band > 0);
        const int first = nodeOfBlock(block, 8 * eight);
        for (int lane = 0; lane < 8; ++lane) node_[lane] = static_cast<std::uint16_t>(first + kLaneNode[lane]);
        place_ = {Float8::load(kLaneX), Float8::load(kLaneY) + Float8::all(static_cast<float>(2 * (eight & 1))),
                  Float8::all(static_cast<float>(eight >> 1))};
        limit_ = limitOf(Float8::load(&brick.cut[node_[0]], &brick.cut[node_[4]]), band);
    }
    /// The same for one to eight nodes of one block.
    LoweredNodes8(const Brick& brick, std::span<const std::uint16_t> nodes, float band) {
        TACTOOTH_ASSERT(!nodes.empty() && nodes.size() <= 8);
        TACTOOTH_ASSERT(band > 0);
        float place[3][8] = {};
        float cut[8];
        std::fill_n(cut, 8, -band);
        for (std::size_t lane = 0; lane < nodes.size(); ++lane) {
            node_[lane] = nodes[lane];
            cut[lane] = brick.cut[nodes[lane]];
            for (int axis = 0; axis < 3; ++axis) {
                place[axis][lane] = static_cast<float>(placeInBrick(nodes[lane], axis) % kBlockSide);
            }
        }
        place_ = Vec3x8::load(place);
        limit_ = limitOf(Float8::load(cut), band);
    }

    void lower(const SweepLanes& step) {
        if (!step.mayReach(place_, limit_)) return;
        const Samples8 samples = step.sample(place_, limit_);
        const std::uint32_t lowered = ~lessEqual(limit_, samples.distance) & 0xFF;
        if (lowered == 0) return;
        lowered_ |= lowered;
        const Float8 isLower = isLess(samples.distance, limit_);
        gradient_ = choose(isLower, samples.gradient, gradient_);
        limit_ = choose(isLower, withoutRounding(samples.distance), limit_);
    }

    /// Calls `visit(sample, lane)` for each lowered node. Values are clamped at -`band` (mm).
    template <class Visit>
    void forEachLowered(float band, const Visit& visit) const {
        if (lowered_ == 0) return;
        float distance[8];
        max(limit_, Float8::all(-band)).store(distance);
        const std::array<OctahedralNormal, 8> normal = OctahedralNormal::pack(gradient_);
        for (std::uint32_t left = lowered_; left != 0; left &= left - 1) {
            const int lane = std::countr_zero(left);
            const auto place = static_cast<std::size_t>(lane);
            visit(CutSample{node_[place], distance[place], normal[place]}, place);
        }
    }

private:
    static Float8 limitOf(Float8 cut, float band) {
        const Float8 limit = min(cut - Float8::all(kLeastChange), Float8::all(band));
        return whereLess(Float8::all(-band), cut, limit, Float8::all(-std::numeric_limits<float>::infinity()));
    }
    static Float8 withoutRounding(Float8 distance) {
        return whereLess(distance, Float8::all(-kLeastDepth), distance, max(distance, Float8::all(0)));
    }

    std::array<std::uint16_t, 8> node_{};
    Vec3x8 place_;  ///< in steps from the block's first node
    Float8 limit_;  ///< a distance must be below it to count; the least distance so far
    Vec3x8 gradient_ = Vec3x8::all(0, 0, 0);
    std::uint32_t lowered_ = 0;
};

}  // namespace

BrickRemoval removableFromBrick(const Brick& brick, const BrickKey& key, const Lattice& lattice,
                                const std::vector<SweepStep>& steps) {
    const double spacing = lattice.spacing();
    const auto band = static_cast<float>(kCutBand * spacing);
    BrickRemoval result;
    result.key = key;
    BrickSweep sweep(key, lattice, steps, band);
    for (int block = 0; block < kBlocks && !sweep.isClear(); ++block) {
        const float highest = highestCut(brick, block);
        if (highest <= -band) continue;  // cannot be lowered any more
        const std::vector<SweepLanes>& near = sweep.nearNodes(block, highest);
        if (near.empty()) continue;
        if (result.lowered.empty()) result.lowered.reserve(kUsuallyLowered);
        for (int eight = 0; eight < kBlockNodes / 8; ++eight) {
            LoweredNodes8 nodes(brick, block, eight, band);
            for (const SweepLanes& step : near) nodes.lower(step);
            nodes.forEachLowered(band,
                                 [&](const CutSample& lowered, std::size_t) { result.lowered.push_back(lowered); });
        }
    }
    findGone(brick, result.lowered, spacing);
    result.volumes = volumesOf(brick, result.lowered, spacing);
    return result;
}

BrickRemoval removableFromNodes(const Brick& brick, const BrickRemoval& whole, const Lattice& lattice,
                                const std::vector<SweepStep>& steps) {
    const double spacing = lattice.spacing();
    const auto band = static_cast<float>(kCutBand * spacing);
    BrickRemoval result;
    result.key = whole.key;
    BrickSweep sweep(whole.key, lattice, steps, band);
    if (sweep.isClear()) return result;
    TACTOOTH_ASSERT(whole.lowered.size() <= kBrickNodes);
    for (auto most = whole.lowered.begin(); most != whole.lowered.end();) {
        const int block = blockOf(most->node);
        const std::vector<SweepLanes>& near = sweep.nearNodes(block, band);
        while (most != whole.lowered.end() && blockOf(most->node) == block) {
            const auto first = most;
            std::array<std::uint16_t, 8> nodes;
            std::size_t count = 0;
            for (; count < 8 && most != whole.lowered.end() && blockOf(most->node) == block; ++most) {
                nodes[count++] = most->node;
            }
            LoweredNodes8 eight(brick, {nodes.data(), count}, band);
            for (const SweepLanes& step : near) eight.lower(step);
            eight.forEachLowered(band, [&](CutSample lowered, std::size_t lane) {
                lowered.gone = first[static_cast<std::ptrdiff_t>(lane)].gone;
                result.lowered.push_back(lowered);
            });
        }
    }
    result.volumes = volumesOf(brick, result.lowered, spacing);
    return result;
}

ChangedBrick carveBrick(Brick& brick, const BrickRemoval& found, std::uint64_t carve) {
    TACTOOTH_ASSERT(carve > brick.lastCarve);
    TACTOOTH_ASSERT(found.lowered.size() <= kBrickNodes);
    ChangedBrick changed{found.key};
    brick.lastCarve = carve;
    brick.lowered.reset();
    brick.opened.reset();
    for (const CutSample& lowered : found.lowered) {
        const int node = lowered.node;
        TACTOOTH_ASSERT(lowered.distance < brick.cut[node]);
        brick.lowered.set(node);
        if (brick.cut[node] >= 0 && lowered.distance < 0) {
            brick.opened.set(node);
            brick.setRemoved(node);
            changed.addNode(node);
        }
        brick.cut[node] = lowered.distance;
        brick.cutNormal[node] = lowered.normal;
        brick.isCut = true;
    }
    return changed;
}

MaterialVolumes removedFromBrick(const Brick& brick, double spacing) {
    TACTOOTH_ASSERT(std::isfinite(spacing) && spacing > 0);
    std::array<double, kBrickNodes> share;
    RemovedFractions shares(brick, spacing);
    for (std::uint16_t node = 0; node < kBrickNodes; ++node) {
        shares.find(node, brick.cut[node], brick.cutNormal[node], share[node]);
    }
    shares.finish();
    MaterialVolumes volumes{};
    for (std::uint16_t node = 0; node < kBrickNodes; ++node) addShare(brick, node, share[node], spacing, volumes);
    return volumes;
}

}  // namespace tactooth
