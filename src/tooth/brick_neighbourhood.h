// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "tooth/brick_map.h"

namespace tactooth {

/// A brick among its neighbours: its nodes and those of one layer around it, local places -1 .. 8 on each axis. A
/// missing neighbour counts as untouched (its side of the tooth does not matter).
class BrickNeighbourhood {
public:
    static constexpr int kSide = kBrickSide + 2;
    using Place = std::array<int, 3>;

    BrickNeighbourhood(const BrickMap& bricks, const BrickKey& key, double spacing)
        : clear_(static_cast<float>(kToothBand * spacing)) {
        for (int i = 0; i < 27; ++i) near_[i] = bricks.find(key.neighbour(i));
        findRemoved();
    }

    [[nodiscard]] static constexpr int index(int x, int y, int z) { return x + 1 + kSide * (y + 1 + kSide * (z + 1)); }
    /// Which nodes of a row along x are removed: bit x + 1 for x from -1 to 8.
    [[nodiscard]] unsigned removedRow(int y, int z) const { return removed_[y + 1 + kSide * (z + 1)]; }
    enum class Share { None, Some, All };
    /// How many of the nodes from `low` to `high`, as far as they are here, are removed.
    [[nodiscard]] Share removedShare(Place low, Place high) const {
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::clamp(low[axis], -1, kBrickSide);
            high[axis] = std::clamp(high[axis], -1, kBrickSide);
        }
        const unsigned row = ((1U << (high[0] - low[0] + 1)) - 1) << (low[0] + 1);
        bool some = false;
        bool all = true;
        for (int z = low[2]; z <= high[2]; ++z) {
            for (int y = low[1]; y <= high[1]; ++y) {
                const unsigned removed = removedRow(y, z) & row;
                some |= removed != 0;
                all &= removed == row;
                if (some && !all) return Share::Some;
            }
        }
        return all ? Share::All : Share::None;
    }
    /// Distance to the tooth's surface, mm.
    [[nodiscard]] float tooth(const Place& p) const {
        const Brick* brick = brickOf(p);
        return brick != nullptr ? brick->tooth[nodeOf(p)] : clear_;
    }
    [[nodiscard]] MaterialId material(const Place& p) const {
        const Brick* brick = brickOf(p);
        return brick != nullptr ? brick->material[nodeOf(p)] : MaterialId{};
    }
    /// Where the border of the removed region crosses the lattice edge from a node to the next on `axis`. One of the
    /// two is removed, and both lie in bricks that exist.
    [[nodiscard]] BorderCrossing border(const Place& p, int axis) const {
        const Brick* brick = brickOf(p);
        return brick != nullptr ? brick->border[axis][nodeOf(p)]
                                : BorderCrossing{0.5F, PackedDirection(Vec3::Unit(axis))};
    }
    /// Whether some nodes are removed and others are not.
    [[nodiscard]] bool hasBorder() const { return hasBorder_; }

private:
    static constexpr int part(int place) { return place < 0 ? 0 : place < kBrickSide ? 1 : 2; }
    static constexpr int local(int place) { return place & (kBrickSide - 1); }
    [[nodiscard]] const Brick* brickOf(const Place& p) const {
        return near_[part(p[0]) + 3 * part(p[1]) + 9 * part(p[2])];
    }
    [[nodiscard]] static int nodeOf(const Place& p) { return nodeIndex(local(p[0]), local(p[1]), local(p[2])); }

    void findRemoved() {
        constexpr unsigned kAll = (1U << kSide) - 1;
        unsigned some = 0;
        unsigned every = kAll;
        for (int z = -1; z <= kBrickSide; ++z) {
            for (int y = -1; y <= kBrickSide; ++y) {
                const Brick* const* bricks = &near_[3 * part(y) + 9 * part(z)];
                const auto row = [&](int i) {
                    return bricks[i] != nullptr ? bricks[i]->removedRow(local(y), local(z)) : 0U;
                };
                const unsigned bits = row(0) >> (kBrickSide - 1) | row(1) << 1 | (row(2) & 1U) << (kSide - 1);
                removed_[y + 1 + kSide * (z + 1)] = static_cast<std::uint16_t>(bits);
                some |= bits;
                every &= bits;
            }
        }
        hasBorder_ = some != 0 && every != kAll;
    }

    std::array<std::uint16_t, kSide * kSide> removed_;
    std::array<const Brick*, 27> near_;
    float clear_;
    bool hasBorder_ = false;
};

}  // namespace tactooth
