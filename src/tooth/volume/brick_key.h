// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>

namespace tactooth {

/// Place of a brick in the lattice of bricks.
struct BrickKey {
    int x, y, z;
    friend auto operator<=>(const BrickKey&, const BrickKey&) = default;

    [[nodiscard]] BrickKey moved(int dx, int dy, int dz) const { return {x + dx, y + dy, z + dz}; }
    /// Of the 27 bricks in it and around it, x first; 13 is itself.
    [[nodiscard]] BrickKey neighbour(int i) const { return moved(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1); }
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
