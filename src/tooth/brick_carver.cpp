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
    float highest = brick.cut[nodeOfBlock(block, 0)];
    for (int i = 1; i < kBlockNodes; ++i) highest = std::max(highest, brick.cut[nodeOfBlock(block, i)]);
    return highest;
}

/// Share of a node's voxel that lies in the tooth and in the removed region.
double removedShare(const Brick& brick, const CutSample& cut, double spacing) {
    const std::uint16_t node = cut.node;
    const double tooth = brick.tooth[node] / spacing;
    const double removed = cut.distance / spacing;
    if (tooth >= kVoxelReach || removed >= kVoxelReach) return 0;
    if (tooth <= -kVoxelReach) return removed <= -kVoxelReach ? 1 : cubeFraction({removed, cut.normal.unpack()});
    return cubeFraction({removed, cut.normal.unpack()}, {tooth, brick.toothNormal[node].unpack()});
}

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

double removableAt(const Brick& brick, const CutSample& lowered, double spacing) {
    const std::uint16_t node = lowered.node;
    const double before = removedShare(brick, {node, brick.cut[node], brick.cutNormal[node]}, spacing);
    return (removedShare(brick, lowered, spacing) - before) * spacing * spacing * spacing;
}

/// Shares a removed volume among the materials of a node's voxel.
void book(MaterialVolumes& volumes, const Brick& brick, int node, double volume) {
    const double beyond = volume * brick.neighbourShare[node] / 255;
    volumes[static_cast<std::size_t>(brick.material[node])] += volume - beyond;
    volumes[static_cast<std::size_t>(brick.neighbour[node])] += beyond;
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
            nodes.forEachLowered(band, [&](const CutSample& lowered) {
                book(result.volumes, brick, lowered.node, removableAt(brick, lowered, spacing));
                result.lowered.push_back(lowered);
            });
        }
    }
    return result;
}

MaterialVolumes removableFromNodes(const Brick& brick, const RemovableInBrick& whole, const Lattice& lattice,
                                   const std::vector<SweepStep>& steps) {
    const double spacing = lattice.spacing();
    const double reach = kVoxelReach * spacing;
    const auto band = static_cast<float>(kCutBand * spacing);
    MaterialVolumes volumes{};
    BrickSweep sweep(whole.key, lattice, steps, reach);
    if (sweep.isClear()) return volumes;
    // What is lowered less far away, in the air, or where all is gone already, has nothing to give.
    const auto gives = [&](const CutSample& most) {
        return most.distance < reach && brick.tooth[most.node] < reach && brick.cut[most.node] > -reach;
    };
    for (auto most = whole.lowered.begin(); most != whole.lowered.end();) {
        const int block = blockOf(most->node);
        const std::vector<SweepLanes>& near = sweep.nearNodes(block, reach);
        while (most != whole.lowered.end() && blockOf(most->node) == block) {
            std::array<std::uint16_t, 8> giving;
            std::size_t count = 0;
            for (; count < 8 && most != whole.lowered.end() && blockOf(most->node) == block; ++most) {
                if (gives(*most)) giving[count++] = most->node;
            }
            LoweredNodes8 nodes(brick, {giving.data(), count}, static_cast<float>(reach));
            for (const SweepLanes& step : near) nodes.lower(step);
            nodes.forEachLowered(band, [&](const CutSample& lowered) {
                book(volumes, brick, lowered.node, removableAt(brick, lowered, spacing));
            });
        }
    }
    return volumes;
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
    MaterialVolumes volumes{};
    for (std::uint16_t node = 0; node < kBrickNodes; ++node) {
        const double share = removedShare(brick, {node, brick.cut[node], brick.cutNormal[node]}, spacing);
        book(volumes, brick, node, share * spacing * spacing * spacing);
    }
    return volumes;
}

}  // namespace tactooth
