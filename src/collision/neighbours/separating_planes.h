// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "collision/neighbours/neighbour_list.h"
#include "geometry/util/assert.h"
#include "geometry/util/pose.h"

namespace tactooth {

/// Cosine between two normals above which their planes count as one: 1.4 microradians apart.
inline constexpr double kSamePlane = 1 - 1e-12;

/// A plane in the tooth's frame with a tooth triangle behind it, and at some pose a tool triangle in front of it.
struct SeparatingPlane {
    Vec3 normal = Vec3::Zero();  ///< unit, from the tooth to the tool; zero: not known yet
    double offset = 0;           ///< every point x of the tooth triangle has normal * x <= offset, mm
    std::uint64_t stamp = 0;     ///< number of the pose (the caller's) at which GJK found it
};

/// A near pair with a plane that separates it.
struct WatchedPair {
    NearPair pair;
    SeparatingPlane plane;
};

/// The pairs that blocked the last steps, the latest first.
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
        TACTOOTH_ASSERT(count_ >= 1 && count_ <= pairs_.size());
    }
    void clear() { count_ = 0; }
    [[nodiscard]] std::size_t size() const { return count_; }
    [[nodiscard]] const NearPair& operator[](std::size_t i) const {
        TACTOOTH_ASSERT(i < count_);
        return pairs_[i];
    }

private:
    std::array<NearPair, 6> pairs_{};  // 3 hold a tool; twice as many while it crosses an edge
    std::size_t count_ = 0;
};

/// Remembers the separating planes of pairs across neighbour lists. For most pairs the plane of the tick before still
/// separates: six multiplications instead of a GJK run. A direct-mapped table of fixed size. Two pairs in the same slot
/// replace each other, which costs time but never gives a wrong result. The slot depends only on the pair, so equal
/// runs stay equal.
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

    /// Stores the plane of a pair; replaces another one in the same slot. Returns the stored plane.
    const SeparatingPlane* store(std::uint64_t partId, const NearPair& pair, const SeparatingPlane& plane) {
        TACTOOTH_ASSERT(isUnit(plane.normal));
        TACTOOTH_ASSERT(std::isfinite(plane.offset));
        Entry& entry = entries_[slot(pair)];
        entry = {epoch_, partId, pair.tooth, pair.tool, plane};
        return &entry.plane;
    }

    /// Forgets all of them.
    void clear() { ++epoch_; }

private:
    static constexpr std::size_t kEntries = 1 << 12;  // 256 kB: more would displace the tooth from the cache

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
    std::uint64_t epoch_ = 1;  // of the valid entries
};

}  // namespace tactooth
