// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "geometry/util/assert.h"
#include "tooth/volume/brick_map.h"

namespace tactooth {

/// The nodes of a brick and one layer of nodes around it, with local positions -1 .. 8 on each axis. An absent
/// neighbour counts as untouched; its side of the tooth does not matter.
class BrickNeighbourhood {
public:
    static constexpr int kSide = kBrickSide + 2;
    static constexpr int kNodes = kSide * kSide * kSide;
    using Place = std::array<int, 3>;

    BrickNeighbourhood(const BrickMap& bricks, const BrickKey& key, double spacing)
        : near_(bricks.around(key)), clear_(static_cast<float>(kToothBand * spacing)) {
        TACTOOTH_ASSERT(std::isfinite(spacing) && spacing > 0);
        findRemoved();
    }

    /// The number of a node in the neighbourhood.
    [[nodiscard]] static constexpr int index(int x, int y, int z) {
        TACTOOTH_ASSERT(x >= -1 && x <= kBrickSide);
        TACTOOTH_ASSERT(y >= -1 && y <= kBrickSide);
        TACTOOTH_ASSERT(z >= -1 && z <= kBrickSide);
        return x + 1 + kSide * (y + 1 + kSide * (z + 1));
    }
    [[nodiscard]] static constexpr Place placeOf(int node) {
        TACTOOTH_ASSERT(node >= 0 && node < kNodes);
        return {node % kSide - 1, node / kSide % kSide - 1, node / (kSide * kSide) - 1};
    }
    /// Step from a node's number to that of the next node on an axis.
    static constexpr std::array<int, 3> kStep = {1, kSide, kSide* kSide};

    /// The removed nodes of a row along x: bit x + 1 for x from -1 to 8.
    [[nodiscard]] unsigned removedRow(int y, int z) const {
        TACTOOTH_ASSERT(y >= -1 && y <= kBrickSide);
        TACTOOTH_ASSERT(z >= -1 && z <= kBrickSide);
        return removed_[y + 1 + kSide * (z + 1)];
    }
    [[nodiscard]] bool isRemoved(int node) const {
        TACTOOTH_ASSERT(node >= 0 && node < kNodes);
        return (removed_[node / kSide] >> node % kSide & 1) != 0;
    }
    /// The removed corners of the cell that begins at a node: bit x + 2 y + 4 z.
    [[nodiscard]] unsigned removedCorners(int cell) const {
        TACTOOTH_ASSERT(cell >= 0 && cell + kStep[0] + kStep[1] + kStep[2] < kNodes);
        TACTOOTH_ASSERT(cell % kSide != kSide - 1);
        const std::uint16_t* const row = &removed_[cell / kSide];
        const int x = cell % kSide;
        const auto pair = [&](int step) { return static_cast<unsigned>(row[step]) >> x & 3U; };
        return pair(0) | pair(1) << 2 | pair(kSide) << 4 | pair(kSide + 1) << 6;
    }
    /// Whether some nodes are removed ...
    [[nodiscard]] bool hasRemoved() const { return hasRemoved_; }
    /// ... and others are not.
    [[nodiscard]] bool hasBoundary() const { return hasBoundary_; }

    /// The crossing of the boundary with the lattice edge from a node to the next one on `axis`. Exactly one of the two
    /// nodes is removed.
    [[nodiscard]] HermiteSample boundary(int node, int axis) const {
        TACTOOTH_ASSERT(axis >= 0 && axis < 3);
        TACTOOTH_ASSERT(isRemoved(node) != isRemoved(node + kStep[axis]));
        const auto [brick, place] = find(node);
        return brick != nullptr ? brick->boundary[axis][place]
                                : HermiteSample{0.5F, OctahedralNormal(Vec3::Unit(axis))};
    }
    [[nodiscard]] MaterialId material(int node) const {
        const auto [brick, place] = find(node);
        return brick != nullptr ? brick->material[place] : MaterialId{};
    }
    /// Signed distance to the tooth's surface, mm.
    [[nodiscard]] float tooth(int node) const {
        const auto [brick, place] = find(node);
        return brick != nullptr ? brick->tooth[place] : clear_;
    }
    /// The distances of a row along x from 0 to 8. Masks use bit x + 1, as in `removedRow`.
    struct ToothRow {
        Float8 first;
        float last;

        [[nodiscard]] unsigned above(float distance) const {
            return (~lessEqual(first, Float8::all(distance)) & 0xFFU) << 1 | static_cast<unsigned>(last > distance)
                                                                                 << (kBrickSide + 1);
        }
        [[nodiscard]] unsigned below(float distance) const {
            return (~lessEqual(Float8::all(distance), first) & 0xFFU) << 1 | static_cast<unsigned>(last < distance)
                                                                                 << (kBrickSide + 1);
        }
    };
    [[nodiscard]] ToothRow toothRow(int y, int z) const {
        const Brick* brick = near_[1 + 3 * part(y) + 9 * part(z)];
        const Float8 first =
            brick != nullptr ? Float8::load(&brick->tooth[nodeIndex(0, local(y), local(z))]) : Float8::all(clear_);
        return {first, tooth(index(kBrickSide, y, z))};
    }
    /// Whether all nodes of the brick and the next ones on each axis lie deeper than `depth` (mm) within the tooth.
    /// False if that is unknown.
    [[nodiscard]] bool isDeeperThan(float depth) const {
        TACTOOTH_ASSERT(depth >= 0);
        const auto isDeep = [&](int i) { return near_[i] != nullptr && near_[i]->maxToothDistance < -depth; };
        return isDeep(13) && isDeep(14) && isDeep(16) && isDeep(22);
    }

private:
    static constexpr int part(int place) { return place < 0 ? 0 : place < kBrickSide ? 1 : 2; }
    static constexpr int local(int place) { return place & (kBrickSide - 1); }

    /// Where a node is stored: the brick and the index in it.
    struct Kept {
        std::uint16_t brick;
        std::uint16_t place;
    };
    static constexpr std::array<Kept, kNodes> allKept() {
        std::array<Kept, kNodes> table{};
        for (int node = 0; node < kNodes; ++node) {
            const auto [x, y, z] = placeOf(node);
            table[node] = {static_cast<std::uint16_t>(part(x) + 3 * part(y) + 9 * part(z)),
                           static_cast<std::uint16_t>(nodeIndex(local(x), local(y), local(z)))};
        }
        return table;
    }
    struct Found {
        const Brick* brick;
        int place;
    };
    [[nodiscard]] Found find(int node) const;

    void findRemoved() {
        constexpr unsigned kAll = (1U << kSide) - 1;
        unsigned some = 0;
        unsigned every = kAll;
        for (int z = -1; z <= kBrickSide; ++z) {
            std::uint16_t* const rows = &removed_[kSide * (z + 1)];
            readRows(near_.data() + 9 * part(z), kBrickSide - 1, 1, local(z), rows);
            readRows(near_.data() + 9 * part(z) + 3, 0, kBrickSide, local(z), rows + 1);
            readRows(near_.data() + 9 * part(z) + 6, 0, 1, local(z), rows + kSide - 1);
            for (int y = 0; y < kSide; ++y) some |= rows[y], every &= rows[y];
        }
        hasRemoved_ = some != 0;
        hasBoundary_ = hasRemoved_ && every != kAll;
    }
    /// Reads the rows from `y` on of three bricks side by side.
    static void readRows(const Brick* const* bricks, int y, int count, int z, std::uint16_t* rows) {
        const auto layerOf = [&](int i) {
            return bricks[i] != nullptr ? bricks[i]->removed.layer(z) >> kBrickSide * y : 0;
        };
        std::uint64_t before = layerOf(0) >> (kBrickSide - 1);
        std::uint64_t here = layerOf(1);
        std::uint64_t next = layerOf(2);
        for (int i = 0; i < count; ++i, before >>= kBrickSide, here >>= kBrickSide, next >>= kBrickSide) {
            rows[i] = static_cast<std::uint16_t>((before & 1) | (here & NodeBits::kFirstRow) << 1 |
                                                 (next & 1) << (kSide - 1));
        }
    }

    std::array<std::uint16_t, kSide * kSide> removed_;
    const BrickMap::Around& near_;
    float clear_;
    bool hasRemoved_ = false;
    bool hasBoundary_ = false;
};

inline BrickNeighbourhood::Found BrickNeighbourhood::find(int node) const {
    static constexpr std::array<Kept, kNodes> kKept = allKept();
    TACTOOTH_ASSERT(node >= 0 && node < kNodes);
    return {near_[kKept[node].brick], kKept[node].place};
}

}  // namespace tactooth
