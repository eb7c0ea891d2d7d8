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

/// Nodes of a brick that a move lowers, seldom more.
constexpr std::size_t kUsuallyLowered = 256;

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

/// Shares of four nodes' voxels at most that lie in the tooth and, with these samples, in the removed region; 0 for
/// those that are not there. Where only the border of the removed region cuts, as nearly always, they are counted
/// side by side.
Eigen::Array4d removedShares(const Brick& brick, double spacing, std::span<const CutSample> samples) {
    Eigen::Array4d distances = Eigen::Array4d::Ones();
    std::array<PackedDirection, 4> normals;
    bool isDeep = true;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        distances[static_cast<int>(i)] = samples[i].distance / spacing;
        normals[i] = samples[i].normal;
        isDeep &= brick.tooth[samples[i].node] / spacing <= -kVoxelReach;
    }
    if ((distances >= kVoxelReach).all()) return Eigen::Array4d::Zero();
    if (isDeep) return cubeFractions(distances, PackedDirection::sizesOf(normals));
    Eigen::Array4d shares = Eigen::Array4d::Zero();
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const HalfSpace removed{distances[static_cast<int>(i)], normals[i].unpack()};
        const double tooth = brick.tooth[samples[i].node] / spacing;
        if (tooth >= kVoxelReach) continue;
        shares[static_cast<int>(i)] = tooth <= -kVoxelReach
                                          ? cubeFraction(removed)
                                          : cubeFraction(removed, {tooth, brick.toothNormal[samples[i].node].unpack()});
    }
    return shares;
}

/// The volumes that samples, four at most, are the borders of; added up by the materials of their nodes' voxels.
class VolumeBook {
public:
    VolumeBook(const Brick& brick, double spacing) : brick_(brick), spacing_(spacing) {}

    /// What lowering the cut field to these samples removes.
    void addLowered(std::span<const CutSample> lowered) {
        std::array<CutSample, 4> before;
        for (std::size_t i = 0; i < lowered.size(); ++i) {
            const std::uint16_t node = lowered[i].node;
            before[i] = {node, brick_.cut[node], brick_.cutNormal[node]};
        }
        const Eigen::Array4d was = removedShares(brick_, spacing_, std::span(before).first(lowered.size()));
        book(lowered, removedShares(brick_, spacing_, lowered) - was);
    }
    /// What is removed up to these samples.
    void add(std::span<const CutSample> samples) { book(samples, removedShares(brick_, spacing_, samples)); }

    [[nodiscard]] const MaterialVolumes& volumes() const { return volumes_; }

private:
    void book(std::span<const CutSample> samples, const Eigen::Array4d& shares) {
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const std::uint16_t node = samples[i].node;
            const double volume = shares[static_cast<int>(i)] * spacing_ * spacing_ * spacing_;
            double& mine = volumes_[static_cast<std::size_t>(brick_.material[node])];
            if (brick_.neighbourShare[node] == 0) {
                mine += volume;
                continue;
            }
            const double beyond = volume * brick_.neighbourShare[node] / 255;
            mine += volume - beyond;
            volumes_[static_cast<std::size_t>(brick_.neighbour[node])] += beyond;
        }
    }

    const Brick& brick_;
    double spacing_;
    MaterialVolumes volumes_{};
};

/// What lowering the cut field of these nodes removes.
MaterialVolumes volumesOf(const Brick& brick, std::span<const CutSample> lowered, double spacing) {
    VolumeBook book(brick, spacing);
    for (; !lowered.empty(); lowered = lowered.subspan(std::min<std::size_t>(4, lowered.size()))) {
        book.addLowered(lowered.first(std::min<std::size_t>(4, lowered.size())));
    }
    return book.volumes();
}

/// Eight nodes of one block, and what a sweep lowers their cut field to.
class LoweredNodes8 {
public:
    /// Nodes 8 `eight` .. 8 `eight` + 7 of a block. A node counts as lowered if a step comes below what it has and
    /// `band` (mm), unless it has -`band` already.
    LoweredNodes8(const Brick& brick, int block, int eight, float band) {
        for (int lane = 0; lane < 8; ++lane)
            node_[lane] = static_cast<std::uint16_t>(nodeOfBlock(block, 8 * eight + lane));
        place_ = {Float8::load(kLaneX), Float8::load(kLaneY) + Float8::all(static_cast<float>(2 * (eight & 1))),
                  Float8::all(static_cast<float>(eight >> 1))};
        limit_ = limitOf(Float8::load(&brick.cut[node_[0]], &brick.cut[node_[4]]), band);
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
        if (!step.mayReach(place_, limit_)) return;
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
        max(limit_, Float8::all(-band)).store(distance);
        const std::array<PackedDirection, 8> normal = PackedDirection::pack(gradient_);
        for (std::uint32_t left = lowered_; left != 0; left &= left - 1) {
            const int lane = std::countr_zero(left);
            visit(CutSample{node_[lane], distance[lane], normal[lane]});
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
        if (result.lowered.empty()) result.lowered.reserve(kUsuallyLowered);
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
            brick.setRemoved(node);
            changed.add(node);
        }
        brick.cut[node] = lowered.distance;
        brick.cutNormal[node] = lowered.normal;
        brick.isCut = true;
    }
    return changed;
}

MaterialVolumes removedFromBrick(const Brick& brick, double spacing) {
    VolumeBook book(brick, spacing);
    for (int first = 0; first < kBrickNodes; first += 4) {
        std::array<CutSample, 4> samples;
        for (int i = 0; i < 4; ++i) {
            const int node = first + i;
            samples[i] = {static_cast<std::uint16_t>(node), brick.cut[node], brick.cutNormal[node]};
        }
        book.add(samples);
    }
    return book.volumes();
}

}  // namespace tactooth
