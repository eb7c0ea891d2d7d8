// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/bvh/binned_sah.h"

#include <algorithm>
#include <array>
#include <vector>

#include "geometry/util/assert.h"
#include "geometry/util/parallel_for.h"

// Binned surface-area heuristic: I. Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", IEEE
// Symposium on Interactive Ray Tracing 2007, section 3; large ranges are binned in parallel as in his section 5.
// Differs from the paper: a leaf is a packet of triangles, so the cost of a part counts packets, not triangles. Items
// in the wrong part are listed without a branch and then exchanged in pairs (S. Edelkamp, A. Weiss, "BlockQuicksort",
// ESA 2016). Several threads can do that, and the result is the same.

namespace tactooth {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// More than 16 bins bring no measurable gain on scanned teeth. For few items, fewer bins find as good a border.
constexpr int kManyBins = 16;
constexpr int kFewBins = 8;
constexpr std::size_t kFewItems = 128;

template <int kBins>
struct Bins {
    std::array<TreeBounds, kBins> bounds;
    std::array<std::uint32_t, kBins> count{};

    void extend(const Bins& other) {
        for (int bin = 0; bin < kBins; ++bin) {
            bounds[bin].extend(other.bounds[bin]);
            count[bin] += other.count[bin];
        }
    }
};

/// Which bin an item falls into, by its centre along the widest axis.
template <int kBins>
struct Binning {
    int axis;
    float low, scale;

    [[nodiscard]] std::uint8_t operator()(const TreeItem& item) const {
        return static_cast<std::uint8_t>(std::min(kBins - 1, static_cast<int>((item.centre(axis) - low) * scale)));
    }
};

/// The sum of the results of `block` over all items. A large range is summed in parallel.
template <class Sum, class Block>
Sum summed(const TreeRange& range, const Block& block) {
    if (range.size() <= kParallelTreeRange) return block(range);
    std::vector<Sum> sums((range.size() - 1) / kParallelTreeRange + 1);
    parallelFor(sums.size(), [&](std::size_t i) {
        const TreeRange rest = range.after(i * kParallelTreeRange);
        sums[i] = block(rest.first(std::min(kParallelTreeRange, rest.size())));
    });
    for (std::size_t i = 1; i < sums.size(); ++i) sums[0].extend(sums[i]);
    return sums[0];
}

/// Fills the bins, and writes the bin of each item beside it.
template <int kBins>
Bins<kBins> fillBins(const TreeRange& range, const Binning<kBins>& binning) {
    return summed<Bins<kBins>>(range, [binOf = binning](const TreeRange& block) {
        Bins<kBins> bins;
        std::uint8_t* noted = block.bins.data();
        for (const TreeItem& item : block.items) {
            const std::uint8_t bin = binOf(item);
            *noted++ = bin;
            bins.bounds[bin].extend(item.bounds());
            ++bins.count[bin];
        }
        return bins;
    });
}

/// The expected cost of a sub-tree of so many items in a box.
float costOf(const TreeBounds& bounds, std::uint32_t count) {
    return bounds.halfArea() * static_cast<float>((count + kLeafSize - 1) / kLeafSize);
}

/// The bin border of the lowest cost, 1..kBins-1; 0 if all items are in one bin. The border after an empty bin gives
/// the same parts as the border before it.
template <int kBins>
int cheapestBorder(const Bins<kBins>& bins) {
    std::array<float, kBins> rightCost;
    TreeBounds right;
    std::uint32_t rightCount = 0;
    for (int bin = kBins - 1; bin > 0; --bin) {
        right.extend(bins.bounds[bin]);
        rightCount += bins.count[bin];
        rightCost[bin] = rightCount != 0 ? costOf(right, rightCount) : 0.0F;
    }
    TreeBounds left;
    std::uint32_t leftCount = 0;
    int best = 0;
    float bestCost = kInfinity;
    for (int border = 1; border < kBins; ++border) {
        left.extend(bins.bounds[border - 1]);
        leftCount += bins.count[border - 1];
        if (leftCount == 0 || rightCost[border] == 0.0F) continue;
        const float both = costOf(left, leftCount) + rightCost[border];
        if (both < bestCost) bestCost = both, best = border;
    }
    return best;
}

/// Writes the indices, from begin to end, of the items that are not in part `left`. Returns their number.
std::size_t listStrays(const TreeRange& range, std::size_t begin, std::size_t end, int border, bool left,
                       std::uint32_t* places) {
    std::size_t count = 0;
    for (std::size_t i = begin; i < end; ++i) {
        places[count] = static_cast<std::uint32_t>(i);
        count += (range.bins[i] < border) != left;
    }
    return count;
}

/// The indices, in order, of all items of the first part that belong into the second, or the reverse.
std::vector<std::uint32_t> allStrays(const TreeRange& range, std::size_t begin, std::size_t end, int border,
                                     bool left) {
    std::vector<std::uint32_t> places(end - begin);
    std::vector<std::size_t> counts((end - begin + kParallelTreeRange - 1) / kParallelTreeRange);
    parallelFor(counts.size(), [&](std::size_t i) {
        const std::size_t from = begin + i * kParallelTreeRange;
        counts[i] = listStrays(range, from, std::min(end, from + kParallelTreeRange), border, left,
                               &places[i * kParallelTreeRange]);
    });
    std::size_t total = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const auto from = places.begin() + static_cast<std::ptrdiff_t>(i * kParallelTreeRange);
        std::copy_n(from, counts[i], places.begin() + static_cast<std::ptrdiff_t>(total));
        total += counts[i];
    }
    places.resize(total);
    return places;
}

/// Brings the items of the bins below `border`, `leftCount` in all, to the front.
void partition(const TreeRange& range, std::size_t leftCount, int border) {
    TACTOOTH_ASSERT(leftCount > 0 && leftCount < range.size());
    if (range.size() > kParallelTreeRange) {
        const std::vector<std::uint32_t> onLeft = allStrays(range, 0, leftCount, border, true);
        const std::vector<std::uint32_t> onRight = allStrays(range, leftCount, range.size(), border, false);
        TACTOOTH_ASSERT(onLeft.size() == onRight.size());
        parallelFor(
            onLeft.size(),
            [&](std::size_t i) { std::swap(range.items[onLeft[i]], range.items[onRight[onRight.size() - 1 - i]]); },
            kParallelTreeRange);
        return;
    }
    std::array<std::uint32_t, kParallelTreeRange + 1> onLeft, onRight;
    std::size_t strays = listStrays(range, 0, leftCount, border, true, onLeft.data());
    listStrays(range, leftCount, range.size(), border, false, onRight.data());
    for (std::size_t i = 0; strays != 0; ++i) std::swap(range.items[onLeft[i]], range.items[onRight[--strays]]);
}

/// Splits at the middle item along the longest axis of the centres. Items with equal keys are ordered by triangle
/// number, so the result does not depend on the library's sorting algorithm.
TreeSplit splitAtMedian(const TreeRange& range, int axis) {
    const std::size_t half = (range.size() + kLeafSize - 1) / kLeafSize / 2 * kLeafSize;
    std::sort(range.items.begin(), range.items.end(), [axis](const TreeItem& a, const TreeItem& b) {
        const float left = a.centre(axis);
        const float right = b.centre(axis);
        return left != right ? left < right : a.triangle() < b.triangle();
    });
    return {half, boundsOf(range.first(half)), boundsOf(range.after(half))};
}

/// Splits at the cheapest border between bins. Along the axis, the centres lie between `low` and `low + size`.
template <int kBins>
TreeSplit splitAtCheapest(const TreeRange& range, int axis, float low, float size) {
    TACTOOTH_ASSERT(size > 0);
    const auto bins = fillBins<kBins>(range, {axis, low, kBins / size});
    const int border = cheapestBorder(bins);
    if (border == 0) return splitAtMedian(range, axis);
    TreeSplit split{0, {}, {}};
    for (int bin = 0; bin < kBins; ++bin) (bin < border ? split.left : split.right).extend(bins.bounds[bin]);
    for (int bin = 0; bin < border; ++bin) split.leftCount += bins.count[bin];
    partition(range, split.leftCount, border);
    return split;
}

}  // namespace

TreeBounds centresOf(const TreeRange& range) {
    return summed<TreeBounds>(range, [](const TreeRange& block) {
        TreeBounds centres;
        for (const TreeItem& item : block.items) centres.extend(item.centre());
        return centres;
    });
}

TreeBounds boundsOf(const TreeRange& range) {
    return summed<TreeBounds>(range, [](const TreeRange& block) {
        TreeBounds bounds;
        for (const TreeItem& item : block.items) bounds.extend(item.bounds());
        return bounds;
    });
}

TreeSplit splitRange(const TreeRange& range, bool balanced) {
    TACTOOTH_ASSERT(range.size() > kLeafSize);
    TACTOOTH_ASSERT(range.bins.size() == range.size());
    const auto [low, high] = centresOf(range).box();
    int axis = 0;
    for (int other = 1; other < 3; ++other) {
        if (high[other] - low[other] > high[axis] - low[axis]) axis = other;
    }
    const float size = high[axis] - low[axis];
    if (balanced || !(size > 0.0F)) return splitAtMedian(range, axis);

    const auto split = range.size() > kFewItems ? splitAtCheapest<kManyBins> : splitAtCheapest<kFewBins>;
    return split(range, axis, low[axis], size);
}

}  // namespace tactooth
