// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cassert>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"
#include "geometry/util/assert.h"

namespace tactooth {

/// Gives equal positions the same vertex number, in order of first appearance. Equal means bit for bit, except that -0
/// equals +0 (the first one is kept). It is an open-addressing hash table with linear probing (Knuth, The Art of
/// Computer Programming 3, section 6.4), at most half full.
class VertexWelder {
public:
    /// `expectedVertices` is the initial size of the table; more may come.
    explicit VertexWelder(std::size_t expectedVertices);

    /// The number of the vertex at `position`, which is finite.
    std::uint32_t add(const Vec3f& position) { return add(position, hash(position)); }

    /// The same for many positions (finite), faster than one by one: `numbers[i]` is that of `positions[i]`.
    void addAll(std::span<const Vec3f> positions, std::uint32_t* numbers);

    /// The distinct positions so far, by number.
    [[nodiscard]] std::span<const Vec3f> vertices() const { return vertices_; }

    /// The distinct positions by number. The welder must not be used afterwards.
    [[nodiscard]] std::vector<Vec3f> takeVertices() { return std::move(vertices_); }

private:
    static constexpr std::uint32_t kFree = 0xffffffffU;

    /// Mixes the bits of the three coordinates (the finaliser of MurmurHash3, by Austin Appleby).
    static std::size_t hash(const Vec3f& position) {
        // Adding +0 turns -0 into +0 and changes nothing else.
        const auto bits = [](float value) { return std::uint64_t{std::bit_cast<std::uint32_t>(value + 0.0F)}; };
        std::uint64_t mixed =
            (bits(position.x()) << 32 | bits(position.y())) ^ (bits(position.z()) * 0x9e3779b97f4a7c15U);
        mixed = (mixed ^ (mixed >> 33)) * 0xff51afd7ed558ccdU;
        mixed = (mixed ^ (mixed >> 33)) * 0xc4ceb9fe1a85ec53U;
        return static_cast<std::size_t>(mixed ^ (mixed >> 33));
    }

    std::uint32_t add(const Vec3f& position, std::size_t hashed) {
        TACTOOTH_ASSERT(position.allFinite());
        for (std::size_t slot = hashed & mask_;; slot = (slot + 1) & mask_) {
            const std::uint32_t vertex = table_[slot];
            if (vertex == kFree) return insert(position, slot);
            if (vertices_[vertex] == position) return vertex;
        }
    }
    std::uint32_t insert(const Vec3f& position, std::size_t slot);
    void grow();

    std::vector<Vec3f> vertices_;
    std::vector<std::uint32_t> table_;  ///< vertex numbers, or kFree
    std::size_t mask_;                  ///< table size (a power of two) - 1
};

/// The mesh of a list of corners, three for each triangle, as in an STL file: equal positions become one vertex. Every
/// triangle stays, in its order, also one with equal corners. `corners.size()` is a multiple of 3.
[[nodiscard]] TriangleMesh weld(std::span<const Vec3f> corners);

}  // namespace tactooth
