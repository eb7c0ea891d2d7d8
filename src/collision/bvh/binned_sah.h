// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>

#include "collision/narrow/simd8.h"
#include "geometry/util/assert.h"
#include "geometry/util/vec.h"

namespace tactooth {

/// A box in one vector register: its lower corner, and its upper corner with the sign reversed. So one minimum extends
/// it. The fourth number of each corner has no meaning.
class TreeBounds {
public:
    TreeBounds() : TreeBounds(Float8::all(std::numeric_limits<float>::infinity())) {}
    explicit TreeBounds(Float8 corners) { corners.store(corners_); }

    void extend(const TreeBounds& other) { min(Float8::load(corners_), Float8::load(other.corners_)).store(corners_); }

    /// The corners as single numbers, mm.
    struct Box {
        float low[3], high[3];
    };
    [[nodiscard]] Box box() const {
        const auto& c = corners_;
        return {{c[0], c[1], c[2]}, {-c[4], -c[5], -c[6]}};
    }
    /// Half the surface of the box, mm^2; not for an empty one.
    [[nodiscard]] float halfArea() const {
        const auto [low, high] = box();
        const float x = high[0] - low[0];
        const float y = high[1] - low[1];
        const float z = high[2] - low[2];
        return x * y + y * z + z * x;
    }

private:
    float corners_[8];
};

/// A triangle for the construction of an AABB tree: its box and its number.
class TreeItem {
public:
    TreeItem() = default;  // writes nothing: the threads that fill a large array touch its memory first
    TreeItem(std::uint32_t triangle, const Vec3f& a, const Vec3f& b, const Vec3f& c) {
        for (int axis = 0; axis < 3; ++axis) {
            corners_[axis] = std::min({a[axis], b[axis], c[axis]});
            corners_[4 + axis] = -std::max({a[axis], b[axis], c[axis]});
        }
        corners_[3] = std::bit_cast<float>(triangle);
        corners_[7] = 0.0F;
    }

    [[nodiscard]] TreeBounds bounds() const { return TreeBounds(Float8::load(corners_)); }
    [[nodiscard]] std::uint32_t triangle() const { return std::bit_cast<std::uint32_t>(corners_[3]); }
    /// Twice the centre of the box.
    [[nodiscard]] float centre(int axis) const { return corners_[axis] - corners_[4 + axis]; }
    /// The same on all axes, as a box without extent.
    [[nodiscard]] TreeBounds centre() const {
        return TreeBounds(Float8::load(corners_) - Float8::load(corners_ + 4, corners_));
    }

private:
    // Written as single numbers, since to assemble a register costs more; read as a whole.
    alignas(32) float corners_[8];
};

/// Items in contiguous memory, each with a byte of scratch memory.
struct TreeRange {
    std::span<TreeItem> items;
    std::span<std::uint8_t> bins;

    [[nodiscard]] std::size_t size() const { return items.size(); }
    [[nodiscard]] TreeRange first(std::size_t count) const {
        TACTOOTH_ASSERT(count <= size());
        return {items.first(count), bins.first(count)};
    }
    [[nodiscard]] TreeRange after(std::size_t count) const {
        TACTOOTH_ASSERT(count <= size());
        return {items.subspan(count), bins.subspan(count)};
    }
};

/// The two parts of a range.
struct TreeSplit {
    std::size_t leftCount;
    TreeBounds left, right;
};

/// The number of items whose work is worth a task of its own: about 50 us.
inline constexpr std::size_t kParallelTreeRange = 8192;

[[nodiscard]] TreeBounds boundsOf(const TreeRange& range);
/// Of the items' centres, doubled as in TreeItem::centre.
[[nodiscard]] TreeBounds centresOf(const TreeRange& range);

/// The most triangles of a leaf.
inline constexpr std::size_t kLeafSize = 8;

/// Reorders `range` (more than one leaf) into two parts, neither of them empty, that make the cheapest pair of
/// sub-trees. With `balanced`: into halves. The result does not depend on the number of threads.
[[nodiscard]] TreeSplit splitRange(const TreeRange& range, bool balanced);

}  // namespace tactooth
