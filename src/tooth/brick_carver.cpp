// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/brick_carver.h"

#include <algorithm>

#include "tooth/voxel_fraction.h"

namespace tactooth {
namespace {

/// Nodes along one side of the blocks that are skipped together when a sweep cannot reach any of them.
constexpr int kBlockSide = 4;
/// Voxels; a change of the cut field above this cannot move its border (a cell's diagonal, and rounding).
constexpr double kMattersBelow = 1.75;

/// mm; a smaller change of the cut field is rounding (of a wall that a bur passes along), not cutting.
constexpr float kLeastChange = 1e-6F;

struct CutSample {
    float distance;
    PackedDirection normal;
};

/// Share of a node's voxel that lies in the tooth and in the removed region.
double removedShare(const Brick& brick, int node, const CutSample& cut, double spacing) {
    const double tooth = brick.tooth[node] / spacing;
    const double removed = cut.distance / spacing;
    constexpr double kReach = 0.8660254037844386;  // half the diagonal of a unit cube
    if (tooth >= kReach || removed >= kReach) return 0;
    if (tooth <= -kReach) return cubeFraction({removed, cut.normal.unpack()});
    return cubeFraction({removed, cut.normal.unpack()}, {tooth, brick.toothNormal[node].unpack()});
}

/// Calls `visit(node, sample)` for each node whose cut distance the steps lower.
template <class Visit>
void forEachLowered(const Brick& brick, const BrickKey& key, const Lattice& lattice,
                    const std::vector<SweepStep>& steps, const Visit& visit) {
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
        near.clear();
        for (const SweepStep& step : steps) {
            if (step.lowerBound(middle) < band + blockReach) near.push_back(&step);
        }
        if (near.empty()) continue;
        for (int i = 0; i < kBlockSide * kBlockSide * kBlockSide; ++i) {
            const int x = x0 + i % kBlockSide;
            const int y = y0 + i / kBlockSide % kBlockSide;
            const int z = z0 + i / (kBlockSide * kBlockSide);
            const int node = nodeIndex(x, y, z);
            CutSample lowered{brick.cut[node], brick.cutNormal[node]};
            if (lowered.distance <= static_cast<float>(-band)) continue;
            const Vec3 point = corner + spacing * Vec3(x, y, z);
            for (const SweepStep* step : near) {
                const FieldSample sample = step->sample(point, lowered.distance);
                const auto distance = static_cast<float>(std::max(sample.distance, -band));
                if (distance < lowered.distance) lowered = {distance, PackedDirection(sample.gradient)};
            }
            if (lowered.distance < brick.cut[node] - kLeastChange) visit(x, y, z, lowered);
        }
    }
}

}  // namespace

BrickCarve carveBrick(Brick& brick, const BrickKey& key, const Lattice& lattice, const std::vector<SweepStep>& steps,
                      std::uint64_t carve) {
    const double spacing = lattice.spacing();
    const double voxelVolume = spacing * spacing * spacing;
    BrickCarve result;
    result.changed.key = key;
    brick.lastCarve = carve;
    brick.lowered.reset();
    brick.opened.reset();
    forEachLowered(brick, key, lattice, steps, [&](int x, int y, int z, const CutSample& lowered) {
        const int node = nodeIndex(x, y, z);
        const double before = removedShare(brick, node, {brick.cut[node], brick.cutNormal[node]}, spacing);
        const double after = removedShare(brick, node, lowered, spacing);
        result.removed[static_cast<std::size_t>(brick.material[node])] += (after - before) * voxelVolume;
        brick.lowered.set(node);
        brick.opened.set(node, brick.cut[node] >= 0 && lowered.distance < 0);
        brick.cut[node] = lowered.distance;
        brick.cutNormal[node] = lowered.normal;
        brick.isCut = true;
        if (lowered.distance > kMattersBelow * spacing) return;
        const std::array<int, 3> place = {x, y, z};
        for (int axis = 0; axis < 3; ++axis) {
            const auto layer = static_cast<std::uint8_t>(place[axis]);
            result.changed.low[axis] = std::min(result.changed.low[axis], layer);
            result.changed.high[axis] = std::max(result.changed.high[axis], layer);
        }
    });
    return result;
}

MaterialVolumes removableFromBrick(const Brick& brick, const BrickKey& key, const Lattice& lattice,
                                   const std::vector<SweepStep>& steps) {
    const double spacing = lattice.spacing();
    MaterialVolumes volumes{};
    forEachLowered(brick, key, lattice, steps, [&](int x, int y, int z, const CutSample& lowered) {
        const int node = nodeIndex(x, y, z);
        const double before = removedShare(brick, node, {brick.cut[node], brick.cutNormal[node]}, spacing);
        const double after = removedShare(brick, node, lowered, spacing);
        volumes[static_cast<std::size_t>(brick.material[node])] += (after - before) * spacing * spacing * spacing;
    });
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
