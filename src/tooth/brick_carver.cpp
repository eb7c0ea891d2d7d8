// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/brick_carver.h"

#include <algorithm>
#include <optional>

#include "tooth/voxel_fraction.h"

namespace tactooth {
namespace {

/// mm; a smaller change of the cut field is rounding (of a wall that a bur passes along), not cutting.
constexpr float kLeastChange = 2e-5F;

/// mm; a node that lies no deeper in what a bur sweeps stays solid. On a wall that runs through nodes the sign is only
/// rounding: each node would choose for itself, and pockets shallower than a float resolves would fold the wall onto
/// itself. As exact as an envelope's distance to a sweep; ten steps of a float at 10 mm.
constexpr double kLeastDepth = 1e-5;

/// Voxels; half the diagonal of a unit cube: no plane farther from a node than this cuts its voxel.
constexpr double kVoxelReach = 0.8660254037844386;

using CutSample = RemovableInBrick::Sample;

/// Share of a node's voxel that lies in the tooth and in the removed region.
double removedShare(const Brick& brick, const CutSample& cut, double spacing) {
    const std::uint16_t node = cut.node;
    const double tooth = brick.tooth[node] / spacing;
    const double removed = cut.distance / spacing;
    if (tooth >= kVoxelReach || removed >= kVoxelReach) return 0;
    if (tooth <= -kVoxelReach) return cubeFraction({removed, cut.normal.unpack()});
    return cubeFraction({removed, cut.normal.unpack()}, {tooth, brick.toothNormal[node].unpack()});
}

double withoutRounding(double distance) { return distance < 0 && distance >= -kLeastDepth ? 0 : distance; }

/// The cut field at a node after the steps; nothing if they leave it as it is, or above `limit`.
std::optional<CutSample> loweredAt(const Brick& brick, int node, const Vec3& point, float limit, double band,
                                   const std::vector<const SweepStep*>& steps) {
    std::optional<CutSample> lowered;
    double bound = std::min(brick.cut[node] - kLeastChange, limit);
    Vec3 gradient = Vec3::Zero();
    for (const SweepStep* step : steps) {
        const FieldSample sample = step->sample(point, bound);
        if (sample.distance >= bound) continue;
        bound = withoutRounding(sample.distance);
        gradient = sample.gradient;
        lowered = CutSample{static_cast<std::uint16_t>(node), static_cast<float>(std::max(bound, -band)), {}};
    }
    if (lowered) lowered->normal = PackedDirection(gradient);
    return lowered;
}

/// The steps that come nearer than `reach` to a point.
void findNear(const std::vector<SweepStep>& steps, const Vec3& point, double reach,
              std::vector<const SweepStep*>& near) {
    near.clear();
    for (const SweepStep& step : steps) {
        if (step.lowerBound(point) < reach) near.push_back(&step);
    }
}
void findNear(const std::vector<const SweepStep*>& steps, const Vec3& point, double reach,
              std::vector<const SweepStep*>& near) {
    near.clear();
    for (const SweepStep* step : steps) {
        if (step->lowerBound(point) < reach) near.push_back(step);
    }
}

Vec3 pointOf(const Lattice& lattice, const Vec3& corner, int node) {
    return corner + lattice.spacing() *
                        Vec3(node % kBrickSide, node / kBrickSide % kBrickSide, node / (kBrickSide * kBrickSide));
}

/// A block of a brick's nodes, and which steps of a sweep can lower them.
class BlockSweep {
public:
    BlockSweep(const Brick& brick, const BrickKey& key, const Lattice& lattice, const std::vector<SweepStep>& steps)
        : brick_(brick), corner_(lattice.corner(key)), lattice_(lattice) {
        const double reach = lattice.halfDiagonal() + kCutBand * lattice.spacing();
        findNear(steps, lattice.centre(key), reach, steps_);
    }

    /// Calls `visit(sample)` for each node of a block (0..7) that the steps lower.
    template <class Visit>
    void forEachLowered(int block, const Visit& visit) {
        const std::array<int, 3> first = {kBlockSide * (block & 1), kBlockSide * (block >> 1 & 1),
                                          kBlockSide * (block >> 2)};
        if (!boundAll(first)) return;
        const double band = kCutBand * lattice_.spacing();
        for (int i = 0; i < kBlockNodes; ++i) {
            const int node = nodeOf(first, i);
            if (brick_.cut[node] <= lowest_) continue;
            chosen_.clear();
            for (std::size_t s = near_.size(); s-- > 0;) {
                if (bounds_[s].lower[i] < limit_[i]) chosen_.push_back(near_[s]);
            }
            if (chosen_.empty()) continue;
            const auto lowered =
                loweredAt(brick_, node, pointOf(lattice_, corner_, node), static_cast<float>(band), band, chosen_);
            if (lowered) visit(*lowered);
        }
    }

private:
    static int nodeOf(const std::array<int, 3>& first, int i) {
        return nodeIndex(first[0] + i % kBlockSide, first[1] + i / kBlockSide % kBlockSide,
                         first[2] + i / (kBlockSide * kBlockSide));
    }

    /// Bounds of all steps that come near; false if none does.
    bool boundAll(const std::array<int, 3>& first) {
        const double spacing = lattice_.spacing();
        lowest_ = static_cast<float>(-kCutBand * spacing);
        float highest = lowest_;
        for (int i = 0; i < kBlockNodes; ++i) {
            const float cut = brick_.cut[nodeOf(first, i)];
            limit_[i] = cut - kLeastChange;
            highest = std::max(highest, cut);
        }
        if (highest <= lowest_) return false;
        const Vec3 corner = corner_ + spacing * Vec3(first[0], first[1], first[2]);
        const double toMiddle = 0.5 * (kBlockSide - 1) * spacing;
        findNear(steps_, corner + Vec3::Constant(toMiddle), highest + toMiddle * std::sqrt(3.0), near_);
        bounds_.resize(near_.size());
        for (std::size_t s = 0; s < near_.size(); ++s) near_[s]->boundBlock(corner, spacing, bounds_[s]);
        for (const BlockBounds& bounds : bounds_) {
            for (int i = 0; i < kBlockNodes; ++i) limit_[i] = std::min(limit_[i], bounds.upper[i]);
        }
        return !near_.empty();
    }

    const Brick& brick_;
    const Vec3 corner_;
    const Lattice& lattice_;
    std::vector<const SweepStep*> steps_;  // that come near the brick
    std::vector<const SweepStep*> near_;   // and the block
    std::vector<BlockBounds> bounds_;
    std::vector<const SweepStep*> chosen_;
    std::array<float, kBlockNodes> limit_;  ///< what a step must come below to count
    float lowest_ = 0;                      ///< of the cut field: a node that is there has nothing more to lose
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
    RemovableInBrick result;
    result.key = key;
    BlockSweep sweep(brick, key, lattice, steps);
    for (int block = 0; block < kBrickNodes / kBlockNodes; ++block) {
        sweep.forEachLowered(block, [&](const CutSample& lowered) {
            book(result.volumes, brick, lowered.node, removableAt(brick, lowered, spacing));
            result.lowered.push_back(lowered);
        });
    }
    return result;
}

MaterialVolumes removableFromNodes(const Brick& brick, const RemovableInBrick& whole, const Lattice& lattice,
                                   const std::vector<SweepStep>& steps) {
    const double spacing = lattice.spacing();
    const double reach = kVoxelReach * spacing;
    const Vec3 corner = lattice.corner(whole.key);
    std::vector<const SweepStep*> near;
    findNear(steps, lattice.centre(whole.key), lattice.halfDiagonal() + reach, near);
    MaterialVolumes volumes{};
    if (near.empty()) return volumes;
    for (const CutSample& most : whole.lowered) {
        const int node = most.node;
        // What is lowered less far away, in the air, or where all is gone already, has nothing to give.
        if (most.distance >= reach || brick.tooth[node] >= reach || brick.cut[node] <= -reach) continue;
        const auto lowered =
            loweredAt(brick, node, pointOf(lattice, corner, node), static_cast<float>(reach), kCutBand * spacing, near);
        if (!lowered) continue;
        book(volumes, brick, node, removableAt(brick, *lowered, spacing));
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
