// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>

#include "geometry/util/assert.h"

namespace tactooth {

/// Bricks lie nearer than this to the origin on each axis, counted in bricks. No tooth that is accepted reaches so far
/// (`kMaxCoordinate` at the finest voxel), and numbers of nodes fit into an int.
inline constexpr int kMaxBrickCoordinate = 1 << 26;

/// Place of a brick in the lattice of bricks.
struct BrickKey {
    int x, y, z;
    friend auto operator<=>(const BrickKey&, const BrickKey&) = default;

    [[nodiscard]] BrickKey moved(int dx, int dy, int dz) const { return {x + dx, y + dy, z + dz}; }
    /// Of the 27 bricks in it and around it, x first; 13 is itself.
    [[nodiscard]] BrickKey neighbour(int i) const {
        TACTOOTH_ASSERT(i >= 0 && i < 27);
        return moved(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    }
    /// Whether it lies nearer to the origin than `kMaxBrickCoordinate` on each axis.
    [[nodiscard]] bool isInRange() const {
        const auto isNear = [](int value) { return value > -kMaxBrickCoordinate && value < kMaxBrickCoordinate; };
        return isNear(x) && isNear(y) && isNear(z);
    }
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

}  // namespace tactooth
