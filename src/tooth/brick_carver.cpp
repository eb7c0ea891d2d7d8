// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/brick_carver.h"

#include <algorithm>
#include <optional>

#include "tooth/voxel_fraction.h"

namespace tactooth {
namespace {

/// Nodes along one side of the blocks that are skipped together when a sweep cannot reach any of them.
constexpr int kBlockSide = 4;
/// Voxels; a change of the cut field above this cannot move its border (a cell's diagonal, and rounding).
constexpr double kMattersBelow = 1.75;

/// mm; a smaller change of the cut field is rounding (of a wall that a bur passes along), not cutting.
constexpr float kLeastChange = 1e-6F;

/// Voxels; half the diagonal of a unit cube: no plane farther from a node than this cuts its voxel.
constexpr double kVoxelReach = 0.8660254037844386;

struct CutSample {
    float distance;
    PackedDirection normal;
};

/// Share of a node's voxel that lies in the tooth and in the removed region.
double removedShare(const Brick& brick, int node, const CutSample& cut, double spacing) {
    const double tooth = brick.tooth[node] / spacing;
    const double removed = cut.distance / spacing;
    if (tooth >= kVoxelReach || removed >= kVoxelReach) return 0;
    if (tooth <= -kVoxelReach) return cubeFraction({removed, cut.normal.unpack()});
    return cubeFraction({removed, cut.normal.unpack()}, {tooth, brick.toothNormal[node].unpack()});
}

/// The cut field at a node after the steps; nothing if they leave it as it is, or above `limit`.
std::optional<CutSample> loweredAt(const Brick& brick, int node, const Vec3& point, float limit, double band,
                                   const std::vector<const SweepStep*>& steps) {
    std::optional<CutSample> lowered;
    float bound = std::min(brick.cut[node], limit);
    for (const SweepStep* step : steps) {
        const FieldSample sample = step->sample(point, bound);
        const auto distance = static_cast<float>(std::max(sample.distance, -band));
        if (distance < bound) lowered = {distance, PackedDirection(sample.gradient)}, bound = distance;
    }
    if (lowered && lowered->distance >= brick.cut[node] - kLeastChange) return std::nullopt;
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

Vec3 pointOf(const Lattice& lattice, const Vec3& corner, int node) {
    return corner + lattice.spacing() *
                        Vec3(node % kBrickSide, node / kBrickSide % kBrickSide, node / (kBrickSide * kBrickSide));
}

/// Calls `visit(node, sample)` for each node whose cut distance the steps lower to below `limit`, except those that
/// `isIdle(node)` passes over.
template <class IsIdle, class Visit>
void forEachLowered(const Brick& brick, const BrickKey& key, const Lattice& lattice,
                    const std::vector<SweepStep>& steps, double limit, const IsIdle& isIdle, const Visit& visit) {
    const double spacing = lattice.spacing();
    const double band = kCutBand * spacing;
    const double blockReach = 0.5 * (kBlockSide - 1) * spacing * std::sqrt(3.0);
    const Vec3 corner = lattice.corner(key);
    std::vector<const SweepStep*> near;
    for (int block = 0; block < 8; ++block) {
        const int x0 = kBlockSide * (block & 1);
        const int y0 = kBlockSide * (block >> 1 & 1);
        const int z0 = kBlockSide * (block >> 2);
        const Vec3 middle = corner + spacing * (Vec3(x0, y0, z0) + Vec3::Constant(0.5 * (kBlockSide - 1)));
        findNear(steps, middle, limit + blockReach, near);
        if (near.empty()) continue;
        for (int i = 0; i < kBlockSide * kBlockSide * kBlockSide; ++i) {
            const int node =
                nodeIndex(x0 + i % kBlockSide, y0 + i / kBlockSide % kBlockSide, z0 + i / (kBlockSide * kBlockSide));
            if (brick.cut[node] <= static_cast<float>(-band) || isIdle(node)) continue;
            const auto lowered =
                loweredAt(brick, node, pointOf(lattice, corner, node), static_cast<float>(limit), band, near);
            if (lowered) visit(node, *lowered);
        }
    }
}

double removableAt(const Brick& brick, int node, const CutSample& lowered, double spacing) {
    const double before = removedShare(brick, node, {brick.cut[node], brick.cutNormal[node]}, spacing);
    return (removedShare(brick, node, lowered, spacing) - before) * spacing * spacing * spacing;
}

}  // namespace

BrickCarve carveBrick(Brick& brick, const BrickKey& key, const Lattice& lattice, const std::vector<SweepStep>& steps,
                      std::uint64_t carve) {
    const double spacing = lattice.spacing();
    BrickCarve result;
    result.changed.key = key;
    brick.lastCarve = carve;
    brick.lowered.reset();
    brick.opened.reset();
    const auto isIdle = [](int) { return false; };
    forEachLowered(brick, key, lattice, steps, kCutBand * spacing, isIdle, [&](int node, const CutSample& lowered) {
        result.removed[static_cast<std::size_t>(brick.material[node])] += removableAt(brick, node, lowered, spacing);
        brick.lowered.set(node);
        brick.opened.set(node, brick.cut[node] >= 0 && lowered.distance < 0);
        brick.cut[node] = lowered.distance;
        brick.cutNormal[node] = lowered.normal;
        brick.isCut = true;
        if (lowered.distance > kMattersBelow * spacing) return;
        const std::array<int, 3> place = {node % kBrickSide, node / kBrickSide % kBrickSide,
                                          node / (kBrickSide * kBrickSide)};
        for (int axis = 0; axis < 3; ++axis) {
            const auto layer = static_cast<std::uint8_t>(place[axis]);
            result.changed.low[axis] = std::min(result.changed.low[axis], layer);
            result.changed.high[axis] = std::max(result.changed.high[axis], layer);
        }
    });
    return result;
}

RemovableInBrick removableFromBrick(const Brick& brick, const BrickKey& key, const Lattice& lattice,
                                    const std::vector<SweepStep>& steps) {
    const double spacing = lattice.spacing();
    const double reach = kVoxelReach * spacing;
    RemovableInBrick result;
    result.nodes.key = key;
    // Voxels in the air, and those that are gone already, have nothing to give.
    const auto isIdle = [&](int node) { return brick.tooth[node] >= reach || brick.cut[node] <= -reach; };
    forEachLowered(brick, key, lattice, steps, reach, isIdle, [&](int node, const CutSample& lowered) {
        result.volumes[static_cast<std::size_t>(brick.material[node])] += removableAt(brick, node, lowered, spacing);
        result.nodes.nodes.push_back(static_cast<std::uint16_t>(node));
    });
    return result;
}

MaterialVolumes removableFromNodes(const Brick& brick, const NodesInBrick& where, const Lattice& lattice,
                                   const std::vector<SweepStep>& steps) {
    const double spacing = lattice.spacing();
    const double reach = kVoxelReach * spacing;
    const Vec3 corner = lattice.corner(where.key);
    std::vector<const SweepStep*> near;
    findNear(steps, lattice.centre(where.key), lattice.halfDiagonal() + reach, near);
    MaterialVolumes volumes{};
    if (near.empty()) return volumes;
    for (const std::uint16_t node : where.nodes) {
        const auto lowered =
            loweredAt(brick, node, pointOf(lattice, corner, node), static_cast<float>(reach), kCutBand * spacing, near);
        if (!lowered) continue;
        volumes[static_cast<std::size_t>(brick.material[node])] += removableAt(brick, node, *lowered, spacing);
    }
    return volumes;
}

MaterialVolumes removedFromBrick(const Brick& brick, double spacing) {
    MaterialVolumes volumes{};
    for (int node = 0; node < kBrickNodes; ++node) {
        const double share = removedShare(brick, node, {brick.cut[node], brick.cutNormal[node]}, spacing);
        volumes[static_cast<std::size_t>(brick.material[node])] += share * spacing * spacing * spacing;
    }
    return volumes;
}

}  // namespace tactooth
