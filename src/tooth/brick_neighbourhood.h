// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "tooth/brick_map.h"

namespace tactooth {

/// The nodes of a brick and of one layer around it, gathered from its neighbours: local places -1 .. 8 on each axis.
/// A missing neighbour counts as untouched (its side of the tooth does not matter).
class BrickNeighbourhood {
public:
    static constexpr int kSide = kBrickSide + 2;

    BrickNeighbourhood(const BrickMap& bricks, const BrickKey& key, double spacing) {
        for (int i = 0; i < 27; ++i) near_[i] = bricks.find(key.moved(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1));
        gather(&Brick::cut, static_cast<float>(kCutBand * spacing), cut_);
        findRemoved();
        if (!hasBorder_) return;
        gather(&Brick::tooth, static_cast<float>(kToothBand * spacing), tooth_);
        gather(&Brick::material, MaterialId{}, material_);
    }

    [[nodiscard]] static constexpr int index(int x, int y, int z) { return x + 1 + kSide * (y + 1 + kSide * (z + 1)); }
    /// Which nodes of a row along x are removed: bit x + 1 for x from -1 to 8.
    [[nodiscard]] unsigned removedRow(int y, int z) const { return removed_[y + 1 + kSide * (z + 1)]; }
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
    /// Whether some gathered nodes are removed and others are not; else nothing but `removedRow` may be asked for.
    [[nodiscard]] bool hasBorder() const { return hasBorder_; }

private:
    static constexpr int kCount = kSide * kSide * kSide;
    static constexpr int part(int place) { return place < 0 ? 0 : place < kBrickSide ? 1 : 2; }
    static constexpr int local(int place) { return (place + kBrickSide) % kBrickSide; }

    /// One field of all nodes, row by row along x.
    template <class Field, class Value>
    void gather(Field field, Value missing, std::array<Value, kCount>& to) const {
        for (int z = -1; z <= kBrickSide; ++z) {
            for (int y = -1; y <= kBrickSide; ++y) {
                const Brick* const* bricks = &near_[3 * part(y) + 9 * part(z)];
                const int from = nodeIndex(0, local(y), local(z));
                Value* row = &to[index(-1, y, z)];
                row[0] = bricks[0] != nullptr ? (bricks[0]->*field)[from + kBrickSide - 1] : missing;
                if (bricks[1] != nullptr) {
                    std::copy_n((bricks[1]->*field).begin() + from, kBrickSide, row + 1);
                } else {
                    std::fill_n(row + 1, kBrickSide, missing);
                }
                row[kSide - 1] = bricks[2] != nullptr ? (bricks[2]->*field)[from] : missing;
            }
        }
    }

    void findRemoved() {
        constexpr unsigned kAll = (1U << kSide) - 1;
        unsigned some = 0;
        unsigned every = kAll;
        for (int row = 0; row < kSide * kSide; ++row) {
            unsigned bits = 0;
            for (int x = 0; x < kSide; ++x) bits |= static_cast<unsigned>(cut_[kSide * row + x] < 0) << x;
            removed_[row] = static_cast<std::uint16_t>(bits);
            some |= bits;
            every &= bits;
        }
        hasBorder_ = some != 0 && every != kAll;
    }

    std::array<float, kCount> cut_;
    std::array<std::uint16_t, kSide * kSide> removed_;
    std::array<float, kCount> tooth_;
    std::array<const Brick*, 27> near_;
    std::array<MaterialId, kCount> material_;
    bool hasBorder_ = false;
};

}  // namespace tactooth
