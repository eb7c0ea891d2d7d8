// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "collision/narrow/unit_normal.h"
#include "collision/neighbours/neighbour_list.h"

namespace tactooth {

/// A plane that has a tooth triangle behind it and once had a tool triangle in front of it, in the tooth's frame.
struct SeparatingPlane {
    Vec3 normal = Vec3::Zero();  ///< unit, from the tooth to the tool; zero: not known yet
    double offset = 0;           ///< every point x of the tooth triangle has normal * x <= offset, mm
    std::uint64_t stamp = 0;     ///< the pose (numbered by the caller) at which GJK found it
};

/// A near pair with the plane that tells it apart.
struct WatchedPair {
    NearPair pair;
    SeparatingPlane plane;
};

/// The few pairs that were in the way last, the latest first.
class RecentPairs {
public:
    void add(const NearPair& pair) {
        const auto end = pairs_.begin() + static_cast<std::ptrdiff_t>(count_);
        auto place = std::find(pairs_.begin(), end, pair);
        if (place == end) {
            count_ = std::min(count_ + 1, pairs_.size());
            place = pairs_.begin() + static_cast<std::ptrdiff_t>(count_) - 1;
        }
        std::move_backward(pairs_.begin(), place, place + 1);
        pairs_.front() = pair;
    }
    void clear() { count_ = 0; }
    [[nodiscard]] std::size_t size() const { return count_; }
    [[nodiscard]] const NearPair& operator[](std::size_t i) const { return pairs_[i]; }

private:
    std::array<NearPair, 6> pairs_{};  // 3 hold a tool, twice as many for an edge that is just being crossed
    std::size_t count_ = 0;
};

/// Remembers separating planes of pairs from one list of near pairs to the next: most pairs are told apart by the plane
/// of the tick before with six multiplications instead of a GJK run. A direct-mapped table of fixed size: two pairs
/// that share a place push each other out, which costs time but never a wrong answer. Places depend on the pair alone,
/// so equal runs stay equal.
class SeparatingPlanes {
public:
    SeparatingPlanes() : entries_(kEntries) {}

    /// The plane last stored for the pair, or null.
    [[nodiscard]] const SeparatingPlane* find(std::uint64_t partId, const NearPair& pair) const {
        const Entry& entry = entries_[slot(pair)];
        const bool same =
            entry.epoch == epoch_ && entry.partId == partId && entry.tooth == pair.tooth && entry.tool == pair.tool;
        return same ? &entry.plane : nullptr;
    }

    const SeparatingPlane* store(std::uint64_t partId, const NearPair& pair, const SeparatingPlane& plane) {
        Entry& entry = entries_[slot(pair)];
        entry = {epoch_, partId, pair.tooth, pair.tool, plane};
        return &entry.plane;
    }

    /// Forgets all of them.
    void clear() { ++epoch_; }

private:
    static constexpr std::size_t kEntries = 1 << 12;  // 256 kB: more would push the tooth out of the cache

    struct alignas(64) Entry {  // one cache line
        std::uint64_t epoch = 0;
        std::uint64_t partId = 0;
        std::uint32_t tooth = 0;
        std::uint32_t tool = 0;
        SeparatingPlane plane;
    };

    /// Fibonacci hashing (D. Knuth, The Art of Computer Programming, vol. 3, section 6.4).
    [[nodiscard]] static std::size_t slot(const NearPair& pair) {
        const std::uint64_t key = (std::uint64_t{pair.part} << 44) ^ (std::uint64_t{pair.tooth} << 20) ^ pair.tool;
        return static_cast<std::size_t>((key * 0x9E3779B97F4A7C15ULL) >> 52U);
    }

    std::vector<Entry> entries_;
    std::uint64_t epoch_ = 1;  // of the entries that count
};

}  // namespace tactooth
