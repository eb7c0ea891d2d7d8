// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "geometry/util/assert.h"
#include "tooth/volume/brick_neighbourhood.h"

namespace tactooth {

/// The removed nodes of a brick and of one layer around it, four rows in each word, for queries of many boxes of nodes.
class RemovedRows {
public:
    using Place = BrickNeighbourhood::Place;
    enum class Coverage { None, Some, All };

    explicit RemovedRows(const BrickNeighbourhood& nodes) {
        for (int z = -1; z <= kBrickSide; ++z) {
            std::uint64_t rows = 0;
            for (int y = kBrickSide; y >= -1; --y) {
                rows = rows << kRow | nodes.removedRow(y, z);
                fromRow_[z + 1][y + 1] = rows;
            }
        }
    }

    /// Whether none, some or all nodes from `low` to `high` are removed. Both lie in the neighbourhood, and `low` is
    /// not above `high`.
    [[nodiscard]] Coverage coverage(const Place& low, const Place& high) const {
        for (int axis = 0; axis < 3; ++axis)
            TACTOOTH_ASSERT(low[axis] >= -1 && low[axis] <= high[axis] && high[axis] <= kBrickSide);
        const std::uint64_t row = ((std::uint64_t{1} << (high[0] - low[0] + 1)) - 1) << (low[0] + 1);
        const std::uint64_t four = row | row << kRow | row << 2 * kRow | row << 3 * kRow;
        bool some = false;
        bool all = true;
        for (int y = low[1]; y <= high[1]; y += 4) {
            const int beyond = y + 3 - high[1];  // rows outside the box
            const std::uint64_t asked = beyond > 0 ? four >> beyond * kRow : four;
            for (int z = low[2]; z <= high[2]; ++z) {
                const std::uint64_t removed = fromRow_[z + 1][y + 1] & asked;
                some |= removed != 0;
                all &= removed == asked;
            }
            if (some && !all) return Coverage::Some;
        }
        return all ? Coverage::All : Coverage::None;
    }

private:
    static constexpr int kRow = 16;  ///< bits of a row in a word
    static constexpr int kSide = BrickNeighbourhood::kSide;
    std::array<std::array<std::uint64_t, kSide>, kSide> fromRow_;  ///< by z and y: that row and the next three
};

}  // namespace tactooth
