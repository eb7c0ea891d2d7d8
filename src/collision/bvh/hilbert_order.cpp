// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/bvh/hilbert_order.h"

#include <algorithm>
#include <array>
#include <vector>

#include "geometry/util/assert.h"

// Sorting along the Hilbert curve: I. Kamel, C. Faloutsos, "On Packing R-trees", CIKM 1993. The index of a cell: J.
// Skilling, "Programming the Hilbert Curve", AIP Conference Proceedings 707, 2004. Differs from the papers: the grid
// has only 8 x 8 x 8 cells, so the indices come from a table.

namespace tactooth {
namespace {

constexpr int kBits = 3;  // of a coordinate: the patch of a cut has eight voxels along each side
constexpr int kSide = 1 << kBits;
constexpr int kPlaces = kSide * kSide * kSide;

constexpr unsigned hilbertIndex(std::array<unsigned, 3> x) {
    for (unsigned high = kSide / 2; high > 1; high >>= 1) {
        for (unsigned& one : x) {
            const unsigned exchanged = (x[0] ^ one) & (high - 1);
            if ((one & high) != 0) {
                x[0] ^= high - 1;
            } else {
                x[0] ^= exchanged;
                one ^= exchanged;
            }
        }
    }
    x[1] ^= x[0];
    x[2] ^= x[1];
    unsigned turned = 0;
    for (unsigned high = kSide / 2; high > 1; high >>= 1) turned ^= (x[2] & high) != 0 ? high - 1 : 0;
    unsigned place = 0;
    for (int bit = kBits - 1; bit >= 0; --bit) {
        for (const unsigned one : x) place = place << 1 | ((one ^ turned) >> bit & 1U);
    }
    return place;
}

/// Hilbert index of each cell; x varies fastest.
constexpr auto kPlaceOfCell = [] {
    std::array<std::uint16_t, kPlaces> places{};
    for (unsigned cell = 0; cell < kPlaces; ++cell)
        places[cell] =
            static_cast<std::uint16_t>(hilbertIndex({cell % kSide, cell / kSide % kSide, cell / kSide / kSide}));
    return places;
}();

}  // namespace

void sortByHilbertIndex(const TreeRange& range) {
    const auto [low, high] = centresOf(range).box();
    const float size = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
    const float scale = size > 0 ? kSide / size : 0;
    const auto placeOf = [&, low = low](const TreeItem& item) {
        int cell = 0;
        for (int axis = 2; axis >= 0; --axis)
            cell = cell * kSide + std::min(static_cast<int>((item.centre(axis) - low[axis]) * scale), kSide - 1);
        return kPlaceOfCell[static_cast<std::size_t>(cell)];
    };
    std::vector<std::uint16_t> places(range.size());
    std::array<std::uint32_t, kPlaces + 1> next{};  // where the next item of each index goes
    for (std::size_t i = 0; i < range.size(); ++i) ++next[(places[i] = placeOf(range.items[i])) + 1U];
    for (std::size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
    std::vector<TreeItem> sorted(range.size());
    for (std::size_t i = 0; i < range.size(); ++i) sorted[next[places[i]]++] = range.items[i];
    TACTOOTH_ASSERT(next[kPlaces] == range.size());
    std::ranges::copy(sorted, range.items.begin());
}

}  // namespace tactooth
