// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>

#include "geometry/vec.h"

namespace tactooth {

/// A box of four numbers a corner, so that a vector register holds one; the fourth means nothing.
struct TreeBounds {
    Eigen::Array4f low = Eigen::Array4f::Constant(std::numeric_limits<float>::infinity());
    Eigen::Array4f high = Eigen::Array4f::Constant(-std::numeric_limits<float>::infinity());

    void extend(const TreeBounds& other) { low = low.min(other.low), high = high.max(other.high); }
    void extend(const Eigen::Array4f& point) { low = low.min(point), high = high.max(point); }
    /// Half the surface of the box, mm^2; 0 for an empty one.
    [[nodiscard]] float halfArea() const {
        if (!(low.x() <= high.x())) return 0.0F;
        const Eigen::Array4f size = high - low;
        return size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
    }
};

/// A triangle on its way into an AABB tree: its box, with its number in the spare place.
class TreeItem {
public:
    TreeItem() = default;  // and no number written, so that the threads that fill a large array touch it first
    TreeItem(std::uint32_t triangle, const Vec3f& a, const Vec3f& b, const Vec3f& c) {
        for (int axis = 0; axis < 3; ++axis) {
            low_[axis] = std::min({a[axis], b[axis], c[axis]});
            high_[axis] = std::max({a[axis], b[axis], c[axis]});
        }
        low_[3] = std::bit_cast<float>(triangle);
        high_[3] = 0.0F;
    }

    [[nodiscard]] TreeBounds bounds() const { return {Corner(low_), Corner(high_)}; }
    [[nodiscard]] std::uint32_t triangle() const { return std::bit_cast<std::uint32_t>(low_[3]); }
    /// Twice the centre of the box.
    [[nodiscard]] Eigen::Array4f centre() const { return Corner(low_) + Corner(high_); }
    [[nodiscard]] float centre(int axis) const { return low_[axis] + high_[axis]; }

private:
    using Corner = Eigen::Map<const Eigen::Array4f, Eigen::Aligned16>;
    // Written number by number, since to put together a register from single numbers costs more; read as a whole.
    alignas(16) float low_[4];
    alignas(16) float high_[4];
};

/// Items that lie side by side, each with a byte of scratch memory.
struct TreeRange {
    std::span<TreeItem> items;
    std::span<std::uint8_t> bins;

    [[nodiscard]] std::size_t size() const { return items.size(); }
    [[nodiscard]] TreeRange first(std::size_t count) const { return {items.first(count), bins.first(count)}; }
    [[nodiscard]] TreeRange after(std::size_t count) const { return {items.subspan(count), bins.subspan(count)}; }
};

/// The parts that a range was cut into.
struct TreeSplit {
    std::size_t leftCount;
    TreeBounds left, right;
};

/// From how many items on the work on them is worth a task of its own: about 50 us.
inline constexpr std::size_t kParallelTreeRange = 8192;

[[nodiscard]] TreeBounds boundsOf(const TreeRange& range);

/// Reorders `range` (of `packet` + 1 items at least) into two parts, neither of them empty, that make the cheapest pair
/// of sub-trees whose leaves hold `packet` items each; with `balanced`, into halves. The result does not depend on the
/// number of threads.
[[nodiscard]] TreeSplit splitRange(const TreeRange& range, std::size_t packet, bool balanced);

}  // namespace tactooth
