// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "geometry/util/vec.h"
#include "tooth/volume/brick.h"

namespace tactooth {

/// Place of a brick in the lattice of bricks.
struct BrickKey {
    int x, y, z;
    friend auto operator<=>(const BrickKey&, const BrickKey&) = default;

    [[nodiscard]] BrickKey moved(int dx, int dy, int dz) const { return {x + dx, y + dy, z + dz}; }
    /// Of the 27 bricks in it and around it, x first; 13 is itself.
    [[nodiscard]] BrickKey neighbour(int i) const { return moved(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1); }
};

/// A node by its number on each axis of the whole lattice.
struct LatticeNode {
    explicit LatticeNode(const Eigen::Vector3i& number)  // eight nodes a side
        : key{number.x() >> 3, number.y() >> 3, number.z() >> 3},
          node(nodeIndex(number.x() & 7, number.y() & 7, number.z() & 7)) {}

    BrickKey key;
    int node;  ///< nodeIndex in that brick
};

/// Spreads keys over the table (the finalizer of MurmurHash3, A. Appleby, on the three packed coordinates).
struct BrickKeyHash {
    [[nodiscard]] std::size_t operator()(const BrickKey& key) const {
        const auto part = [](int value) { return static_cast<std::uint64_t>(value + (1 << 20)) & 0x1FFFFF; };
        std::uint64_t bits = part(key.x) | part(key.y) << 21 | part(key.z) << 42;
        bits = (bits ^ (bits >> 33)) * 0xff51afd7ed558ccdULL;
        bits = (bits ^ (bits >> 33)) * 0xc4ceb9fe1a85ec53ULL;
        return bits ^ (bits >> 33);
    }
};

/// The lattice of nodes: node (i, j, k) stands at origin + spacing * (i, j, k).
class Lattice {
public:
    explicit Lattice(double spacing) : spacing_(spacing) {}

    [[nodiscard]] double spacing() const { return spacing_; }
    [[nodiscard]] Vec3 node(int i, int j, int k) const {
        // Off the round numbers on which flat faces of modelled shapes lie: a node on a face has no clear side.
        return spacing_ * Vec3(i + 0.371, j + 0.443, k + 0.517);
    }
    /// A node by its place in or beside a brick: the same bits whichever brick it is counted from.
    [[nodiscard]] Vec3 node(const BrickKey& key, const std::array<int, 3>& place) const {
        return node(kBrickSide * key.x + place[0], kBrickSide * key.y + place[1], kBrickSide * key.z + place[2]);
    }
    /// First node of a brick.
    [[nodiscard]] Vec3 corner(const BrickKey& key) const {
        return node(kBrickSide * key.x, kBrickSide * key.y, kBrickSide * key.z);
    }
    /// Middle of a brick's nodes.
    [[nodiscard]] Vec3 centre(const BrickKey& key) const {
        return corner(key) + Vec3::Constant(0.5 * (kBrickSide - 1) * spacing_);
    }
    /// Distance from the centre of a brick to its corner nodes, mm.
    [[nodiscard]] double halfDiagonal() const { return 0.5 * (kBrickSide - 1) * spacing_ * std::sqrt(3.0); }
    /// The brick whose nodes and the cells above them hold `point`.
    [[nodiscard]] BrickKey brickAt(const Vec3& point) const {
        const Vec3 place = (point - node(0, 0, 0)) / (kBrickSide * spacing_);
        return {static_cast<int>(std::floor(place.x())), static_cast<int>(std::floor(place.y())),
                static_cast<int>(std::floor(place.z()))};
    }
    /// Every brick that owns a node or a cell within `box`, in ascending order.
    [[nodiscard]] std::vector<BrickKey> bricksTouching(const Box3& box) const {
        const BrickKey low = brickAt(box.min());
        const BrickKey high = brickAt(box.max());
        std::vector<BrickKey> keys;
        for (int x = low.x; x <= high.x; ++x) {
            for (int y = low.y; y <= high.y; ++y) {
                for (int z = low.z; z <= high.z; ++z) keys.push_back({x, y, z});
            }
        }
        return keys;
    }

private:
    double spacing_;
};

/// The bricks that have been made so far. A brick clear of the tooth is remembered as absent.
class BrickMap {
public:
    /// A brick and those around it, as BrickKey::neighbour counts them; null where there is none.
    using Around = std::array<const Brick*, 27>;

    [[nodiscard]] bool knows(const BrickKey& key) const { return bricks_.contains(key); }
    /// What `find` gives, if the map knows of it.
    [[nodiscard]] std::optional<Brick*> known(const BrickKey& key) {
        const auto found = bricks_.find(key);
        return found == bricks_.end() ? std::nullopt : std::optional(found->second.brick.get());
    }
    [[nodiscard]] const Brick* find(const BrickKey& key) const {
        const auto found = bricks_.find(key);
        return found == bricks_.end() ? nullptr : found->second.brick.get();
    }
    [[nodiscard]] Brick* find(const BrickKey& key) {
        const auto found = bricks_.find(key);
        return found == bricks_.end() ? nullptr : found->second.brick.get();
    }
    /// Kept with each brick, since its surface is asked for far more often than bricks are made.
    [[nodiscard]] const Around& around(const BrickKey& key) const {
        static constexpr Around kNone{};
        const auto found = bricks_.find(key);
        return found == bricks_.end() ? kNone : found->second.around;
    }
    /// A key that is not known yet.
    void insert(const BrickKey& key, std::unique_ptr<Brick> brick) {
        Entry& entry = bricks_[key];
        entry.brick = std::move(brick);
        for (int i = 0; i < 27; ++i) {
            const auto found = bricks_.find(key.neighbour(i));
            if (found == bricks_.end()) continue;
            entry.around[i] = found->second.brick.get();
            found->second.around[26 - i] = entry.brick.get();
        }
    }
    void clear() { bricks_.clear(); }
    /// Keys of the bricks that exist, in ascending order.
    [[nodiscard]] std::vector<BrickKey> keys() const {
        std::vector<BrickKey> result;
        for (const auto& [key, entry] : bricks_) {
            if (entry.brick) result.push_back(key);
        }
        std::sort(result.begin(), result.end());
        return result;
    }

private:
    struct Entry {
        std::unique_ptr<Brick> brick;
        Around around{};
    };
    std::unordered_map<BrickKey, Entry, BrickKeyHash> bricks_;
};

}  // namespace tactooth
