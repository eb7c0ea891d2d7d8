// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/brick_carver.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <span>

#include "collision/lane_flags.h"
#include "tooth/brick_sweep.h"
#include "tooth/voxel_fraction.h"

namespace tactooth {
namespace {

/// mm; a smaller change of the cut field is rounding (of a wall that a bur passes along), not cutting.
constexpr float kLeastChange = 2e-5F;

/// mm; a node that lies no deeper in what a bur sweeps stays solid. On a wall that runs through nodes the sign is only
/// rounding: each node would choose for itself, and pockets shallower than a float resolves would fold the wall onto
/// itself. As exact as an envelope's distance to a sweep; ten steps of a float at 10 mm.
constexpr float kLeastDepth = 1e-5F;

/// Voxels; half the diagonal of a unit cube: no plane farther from a node than this cuts its voxel.
constexpr double kVoxelReach = 0.8660254037844386;

using CutSample = RemovableInBrick::Sample;

// Eight nodes side by side: (x, y) = (0..3, y..y+1).
constexpr float kLaneX[8] = {0, 1, 2, 3, 0, 1, 2, 3};
constexpr float kLaneY[8] = {0, 0, 0, 0, 1, 1, 1, 1};

float highestCut(const Brick& brick, int block) {
    Eigen::Array4f highest = Eigen::Array4f::Constant(-std::numeric_limits<float>::infinity());
    for (int i = 0; i < kBlockNodes; i += kBlockSide) {
        highest = highest.max(Eigen::Map<const Eigen::Array4f>(&brick.cut[nodeOfBlock(block, i)]));
    }
    return std::max(std::max(highest[0], highest[1]), std::max(highest[2], highest[3]));
}

/// Shares of nodes' voxels that lie in the tooth and in the removed region. Those that only the border of the removed
/// region cuts, as most do, are counted four at a time.
class RemovedShares {
public:
    RemovedShares(const Brick& brick, double spacing) : brick_(brick), spacing_(spacing) {}

    void add(const CutSample& cut) {
        const std::uint16_t node = cut.node;
        const double tooth = brick_.tooth[node] / spacing_;
        const double removed = cut.distance / spacing_;
        if (tooth >= kVoxelReach || removed >= kVoxelReach) {
            shares_.push_back(0);
        } else if (tooth > -kVoxelReach) {
            shares_.push_back(cubeFraction({removed, cut.normal.unpack()}, {tooth, brick_.toothNormal[node].unpack()}));
        } else if (removed <= -kVoxelReach) {
            shares_.push_back(1);
        } else {
            distances_[waiting_] = removed;
            normals_[waiting_] = cut.normal;
            places_[waiting_++] = shares_.size();
            shares_.push_back(0);
            if (waiting_ == 4) count();
        }
    }
    /// In the order in which they were added.
    [[nodiscard]] const std::vector<double>& all() {
        count();
        return shares_;
    }

private:
    void count() {
        const Eigen::Array4d shares = cubeFractions(distances_, PackedDirection::sizesOf(normals_));
        for (int i = 0; i < waiting_; ++i) shares_[places_[i]] = shares[i];
        waiting_ = 0;
    }

    const Brick& brick_;
    double spacing_;
    std::vector<double> shares_;
    Eigen::Array4d distances_ = Eigen::Array4d::Zero();  // of those that are not counted yet
    std::array<PackedDirection, 4> normals_;
    std::array<std::size_t, 4> places_{};
    int waiting_ = 0;
};

/// Eight nodes of one block, and what a sweep lowers their cut field to.
class LoweredNodes8 {
public:
    /// Nodes 8 `eight` .. 8 `eight` + 7 of a block. A node counts as lowered if a step comes below what it has and
    /// `band` (mm), unless it has -`band` already.
    LoweredNodes8(const Brick& brick, int block, int eight, float band) {
        float cut[8];
        for (int lane = 0; lane < 8; ++lane) {
            node_[lane] = static_cast<std::uint16_t>(nodeOfBlock(block, 8 * eight + lane));
            cut[lane] = brick.cut[node_[lane]];
        }
        place_ = {Float8::load(kLaneX), Float8::load(kLaneY) + Float8::all(static_cast<float>(2 * (eight & 1))),
                  Float8::all(static_cast<float>(eight >> 1))};
        limit_ = limitOf(Float8::load(cut), band);
    }
    /// The same for any nodes of one block, eight at most.
    LoweredNodes8(const Brick& brick, std::span<const std::uint16_t> nodes, float band) {
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
        const Samples8 samples = step.sample(place_, limit_);
        const std::uint32_t lowered = ~lessEqual(limit_, samples.distance) & 0xFF;
        if (lowered == 0) return;
        lowered_ |= lowered;
        const Float8 isLower = isLess(samples.distance, limit_);
        gradient_ = choose(isLower, samples.gradient, gradient_);
        limit_ = choose(isLower, withoutRounding(samples.distance), limit_);
    }

    /// Calls `visit(sample)` for each node that was lowered; the cut field ends at -`band` (mm).
    template <class Visit>
    void forEachLowered(float band, const Visit& visit) const {
        if (lowered_ == 0) return;
        float distance[8];
        float gradient[3][8];
        max(limit_, Float8::all(-band)).store(distance);
        gradient_.store(gradient);
        for (std::uint32_t left = lowered_; left != 0; left &= left - 1) {
            const int lane = std::countr_zero(left);
            visit(CutSample{node_[lane], distance[lane],
                            PackedDirection(Vec3(gradient[0][lane], gradient[1][lane], gradient[2][lane]))});
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
    Float8 limit_;  ///< what a step must come below to count: its distance, once one has
    Vec3x8 gradient_ = Vec3x8::all(0, 0, 0);
    std::uint32_t lowered_ = 0;
};

/// Shares a removed volume among the materials of a node's voxel.
void book(MaterialVolumes& volumes, const Brick& brick, int node, double volume) {
    const double beyond = volume * brick.neighbourShare[node] / 255;
    volumes[static_cast<std::size_t>(brick.material[node])] += volume - beyond;
    volumes[static_cast<std::size_t>(brick.neighbour[node])] += beyond;
}

/// What lowering the cut field of these nodes removes.
MaterialVolumes volumesOf(const Brick& brick, std::span<const CutSample> lowered, double spacing) {
    RemovedShares shares(brick, spacing);
    for (const CutSample& sample : lowered) {
        shares.add({sample.node, brick.cut[sample.node], brick.cutNormal[sample.node]});
        shares.add(sample);
    }
    MaterialVolumes volumes{};
    const double* share = shares.all().data();
    for (const CutSample& sample : lowered) {
        const double before = *share++;
        book(volumes, brick, sample.node, (*share++ - before) * spacing * spacing * spacing);
    }
    return volumes;
}

}  // namespace

RemovableInBrick removableFromBrick(const Brick& brick, const BrickKey& key, const Lattice& lattice,
                                    const std::vector<SweepStep>& steps) {
    const double spacing = lattice.spacing();
    const auto band = static_cast<float>(kCutBand * spacing);
    RemovableInBrick result;
    result.key = key;
    BrickSweep sweep(key, lattice, steps, band);
    for (int block = 0; block < kBlocks && !sweep.isClear(); ++block) {
        const float highest = highestCut(brick, block);
        if (highest <= -band) continue;  // nothing more to lose
        const std::vector<SweepLanes>& near = sweep.nearNodes(block, highest);
        if (near.empty()) continue;
        for (int eight = 0; eight < kBlockNodes / 8; ++eight) {
            LoweredNodes8 nodes(brick, block, eight, band);
            for (const SweepLanes& step : near) nodes.lower(step);
            nodes.forEachLowered(band, [&](const CutSample& lowered) { result.lowered.push_back(lowered); });
        }
    }
    result.volumes = volumesOf(brick, result.lowered, spacing);
    return result;
}

RemovableInBrick removableFromNodes(const Brick& brick, const RemovableInBrick& whole, const Lattice& lattice,
                                    const std::vector<SweepStep>& steps) {
    const double spacing = lattice.spacing();
    const auto band = static_cast<float>(kCutBand * spacing);
    RemovableInBrick result;
    result.key = whole.key;
    BrickSweep sweep(whole.key, lattice, steps, band);
    if (sweep.isClear()) return result;
    for (auto most = whole.lowered.begin(); most != whole.lowered.end();) {
        const int block = blockOf(most->node);
        const std::vector<SweepLanes>& near = sweep.nearNodes(block, band);
        while (most != whole.lowered.end() && blockOf(most->node) == block) {
            std::array<std::uint16_t, 8> nodes;
            std::size_t count = 0;
            for (; count < 8 && most != whole.lowered.end() && blockOf(most->node) == block; ++most) {
                nodes[count++] = most->node;
            }
            LoweredNodes8 eight(brick, {nodes.data(), count}, band);
            for (const SweepLanes& step : near) eight.lower(step);
            eight.forEachLowered(band, [&](const CutSample& lowered) { result.lowered.push_back(lowered); });
        }
    }
    result.volumes = volumesOf(brick, result.lowered, spacing);
    return result;
}

ChangedBrick carveBrick(Brick& brick, const RemovableInBrick& found, std::uint64_t carve) {
    ChangedBrick changed{found.key};
    brick.lastCarve = carve;
    brick.lowered.reset();
    brick.opened.reset();
    for (const CutSample& lowered : found.lowered) {
        const int node = lowered.node;
        brick.lowered.set(node);
        if (brick.cut[node] >= 0 && lowered.distance < 0) {
            brick.opened.set(node);
            changed.add(node);
        }
        brick.cut[node] = lowered.distance;
        brick.cutNormal[node] = lowered.normal;
        brick.isCut = true;
    }
    return changed;
}

MaterialVolumes removedFromBrick(const Brick& brick, double spacing) {
    RemovedShares shares(brick, spacing);
    for (std::uint16_t node = 0; node < kBrickNodes; ++node) {
        shares.add({node, brick.cut[node], brick.cutNormal[node]});
    }
    MaterialVolumes volumes{};
    const double* share = shares.all().data();
    for (int node = 0; node < kBrickNodes; ++node) book(volumes, brick, node, *share++ * spacing * spacing * spacing);
    return volumes;
}

}  // namespace tactooth
