// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

#include "geometry/util/assert.h"

namespace tactooth {

/// Number of durations shorter than `upTo`, us, and not shorter than the limit of the bin before.
struct LatencyBin {
    double upTo;
    std::uint64_t count;
};

/// The counts of all buckets of a LatencyHistogram at one moment.
class LatencyCounts {
public:
    /// The quantile (0..1) of all durations, us, up to 3 % too large; 0 without entries.
    [[nodiscard]] double quantile(double quantile) const;
    [[nodiscard]] std::uint64_t total() const;
    /// Number of durations from `low` to below `high`, us; a bucket counts by its lower end.
    [[nodiscard]] std::uint64_t between(double low, double high) const;
    /// All durations in bins one octave wide, from the first to the last that is not empty. The first possible bin also
    /// holds what is shorter than 0.1 us, and the last what is longer than a minute.
    [[nodiscard]] std::vector<LatencyBin> octaves() const;
    /// The durations that were added since an earlier moment of the same histogram.
    [[nodiscard]] LatencyCounts since(const LatencyCounts& earlier) const;

private:
    friend class LatencyHistogram;
    static constexpr int kPerOctave = 24;
    static constexpr int kBuckets = 30 * kPerOctave;

    std::array<std::uint32_t, kBuckets> counts_{};
};

/// Histogram of durations in buckets of 3 % width, from 0.1 us to a minute. One thread adds, any thread reads; adding
/// takes a few nanoseconds.
class LatencyHistogram {
public:
    void add(double microseconds) {
        count(bucketOf(microseconds)).fetch_add(1, std::memory_order_relaxed);
        if (microseconds > largest_.load(std::memory_order_relaxed)) {
            largest_.store(microseconds, std::memory_order_relaxed);
        }
    }

    /// The quantile (0..1) of all durations, us; 0 without entries.
    [[nodiscard]] double quantile(double quantile) const;
    [[nodiscard]] double largest() const { return largest_.load(std::memory_order_relaxed); }
    [[nodiscard]] std::uint64_t total() const { return counts().total(); }
    [[nodiscard]] LatencyCounts counts() const;
    void clear();

private:
    static constexpr int kBuckets = LatencyCounts::kBuckets;
    [[nodiscard]] static int bucketOf(double microseconds);
    [[nodiscard]] std::atomic<std::uint32_t>& count(int bucket) {
        TACTOOTH_ASSERT(bucket >= 0 && bucket < kBuckets);
        return counts_[static_cast<std::size_t>(bucket)];
    }

    std::array<std::atomic<std::uint32_t>, kBuckets> counts_{};
    std::atomic<double> largest_{0};
};

}  // namespace tactooth
