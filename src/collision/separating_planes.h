// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "collision/near_pairs.h"

namespace tactooth {

/// A plane that has a tooth triangle behind it and once had a tool triangle in front of it, in the tooth's frame.
struct SeparatingPlane {
    Vec3 normal = Vec3::Zero();  ///< unit, from the tooth to the tool; zero: not known yet
    double offset = 0;           ///< every point x of the tooth triangle has normal * x <= offset, mm
    std::uint64_t stamp = 0;     ///< the pose (numbered by the caller) at which GJK found it
};

/// Remembers the last separating plane of each pair of triangles, over rounds and ticks: most pairs are told apart by
/// the plane of the tick before with six multiplications instead of a GJK run. A direct-mapped table of fixed size: two
/// pairs that share a place push each other out, which costs time but never a wrong answer.
class SeparatingPlanes {
public:
    SeparatingPlanes() : entries_(kEntries) {}

    /// The place of a pair; `plane.normal` is zero if nothing is known about it.
    [[nodiscard]] SeparatingPlane& of(std::uint64_t partId, const NearPair& pair) {
        Entry& entry = entries_[slot(partId, pair)];
        if (entry.partId != partId || entry.tooth != pair.tooth || entry.tool != pair.tool) {
            entry = {partId, pair.tooth, pair.tool, {}};
        }
        return entry.plane;
    }

    void clear() { std::fill(entries_.begin(), entries_.end(), Entry{}); }

private:
    static constexpr std::size_t kEntries = 1 << 14;  // 1 MB; conformal contact keeps a few thousand pairs busy

    struct Entry {
        std::uint64_t partId = 0;
        std::uint32_t tooth = 0;
        std::uint32_t tool = 0;
        SeparatingPlane plane;
    };

    /// Fibonacci hashing (D. Knuth, The Art of Computer Programming, vol. 3, section 6.4).
    [[nodiscard]] static std::size_t slot(std::uint64_t partId, const NearPair& pair) {
        const std::uint64_t key = (partId * 0x9E3779B97F4A7C15ULL) ^ (std::uint64_t{pair.tooth} << 20) ^ pair.tool;
        return static_cast<std::size_t>((key * 0x9E3779B97F4A7C15ULL) >> 50U);
    }

    std::vector<Entry> entries_;
};

}  // namespace tactooth
