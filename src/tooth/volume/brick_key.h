// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>

#include "geometry/util/assert.h"

namespace tactooth {

/// Upper bound of a brick's coordinates, counted in bricks. No accepted tooth reaches it (`kMaxCoordinate` at the
/// finest voxel), and node numbers fit into an int.
inline constexpr int kMaxBrickCoordinate = 1 << 26;

/// Position of a brick in the lattice of bricks.
struct BrickKey {
    int x, y, z;
    friend auto operator<=>(const BrickKey&, const BrickKey&) = default;

    [[nodiscard]] BrickKey moved(int dx, int dy, int dz) const { return {x + dx, y + dy, z + dz}; }
    /// One of the 27 bricks around and including this one, x first. Number 13 is the brick itself.
    [[nodiscard]] BrickKey neighbour(int i) const {
        TACTOOTH_ASSERT(i >= 0 && i < 27);
        return moved(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    }
    /// Whether all coordinates are below `kMaxBrickCoordinate` in size.
    [[nodiscard]] bool isInRange() const {
        const auto isNear = [](int value) { return value > -kMaxBrickCoordinate && value < kMaxBrickCoordinate; };
        return isNear(x) && isNear(y) && isNear(z);
    }
};

/// Hash of a key: the finalizer of MurmurHash3 (A. Appleby) on the three packed coordinates.
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
