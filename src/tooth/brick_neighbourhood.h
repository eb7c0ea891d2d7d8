// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "tooth/brick_map.h"

namespace tactooth {

/// The nodes of a brick and of one layer around it, gathered from its neighbours: local places -1 .. 8 on each axis.
/// A missing neighbour counts as untouched (its side of the tooth does not matter).
class BrickNeighbourhood {
public:
    static constexpr int kSide = kBrickSide + 2;

    BrickNeighbourhood(const BrickMap& bricks, const BrickKey& key, double spacing) {
        for (int i = 0; i < 27; ++i) near_[i] = bricks.find(key.moved(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1));
        for (int z = -1; z <= kBrickSide; ++z) {
            for (int y = -1; y <= kBrickSide; ++y) {
                for (int x = -1; x <= kBrickSide; ++x) {
                    const Brick* brick = near_[part(x) + 3 * part(y) + 9 * part(z)];
                    gather(brick, nodeIndex(local(x), local(y), local(z)), index(x, y, z), spacing);
                }
            }
        }
    }

    [[nodiscard]] static constexpr int index(int x, int y, int z) { return x + 1 + kSide * (y + 1 + kSide * (z + 1)); }
    [[nodiscard]] float cut(int node) const { return cut_[node]; }
    [[nodiscard]] float tooth(int node) const { return tooth_[node]; }
    /// Where the border of the removed region crosses the lattice edge from a node to the next on `axis`, 0..1 of the
    /// way, with the normal there. One of the two is removed, and both lie in bricks that exist.
    struct Border {
        double place;
        Vec3 normal;
    };
    [[nodiscard]] Border border(const std::array<int, 3>& p, int axis) const {
        const Brick* brick = near_[part(p[0]) + 3 * part(p[1]) + 9 * part(p[2])];
        if (brick == nullptr) return {0.5, Vec3::Unit(axis)};
        const int node = nodeIndex(local(p[0]), local(p[1]), local(p[2]));
        return {brick->borderPlace[axis][node], brick->borderNormal[axis][node].unpack()};
    }
    [[nodiscard]] MaterialId material(int node) const { return material_[node]; }
    /// Whether some gathered nodes are removed and others are not.
    [[nodiscard]] bool hasBorder() const { return hasRemoved_ && hasSolid_; }

private:
    static constexpr int kCount = kSide * kSide * kSide;
    static constexpr int part(int place) { return place < 0 ? 0 : place < kBrickSide ? 1 : 2; }
    static constexpr int local(int place) { return (place + kBrickSide) % kBrickSide; }

    void gather(const Brick* brick, int from, int to, double spacing) {
        if (brick != nullptr) {
            cut_[to] = brick->cut[from];
            tooth_[to] = brick->tooth[from];
            material_[to] = brick->material[from];
        } else {
            cut_[to] = static_cast<float>(kCutBand * spacing);
            tooth_[to] = static_cast<float>(kToothBand * spacing);
            material_[to] = MaterialId{};
        }
        (cut_[to] < 0 ? hasRemoved_ : hasSolid_) = true;
    }

    std::array<float, kCount> cut_;
    std::array<float, kCount> tooth_;
    std::array<const Brick*, 27> near_;
    std::array<MaterialId, kCount> material_;
    bool hasRemoved_ = false;
    bool hasSolid_ = false;
};

}  // namespace tactooth
