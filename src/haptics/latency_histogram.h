// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

namespace tactooth {

/// How many durations are shorter than `upTo`, us, and not shorter than that of the bin before.
struct LatencyBin {
    double upTo;
    std::uint64_t count;
};

/// How many durations fell into each bucket of a LatencyHistogram at one moment.
class LatencyCounts {
public:
    /// The duration that a share `quantile` (0..1) of all stays below, us, up to 3 % more; 0 without entries.
    [[nodiscard]] double quantile(double quantile) const;
    [[nodiscard]] std::uint64_t total() const;
    /// How many lie from `low` to below `high`, us, where a bucket counts by its lower end.
    [[nodiscard]] std::uint64_t between(double low, double high) const;
    /// All of them in bins an octave wide, from the first to the last that is not empty. What is shorter than a
    /// microsecond's tenth is in the first bin that there can be, what is longer than a minute in the last.
    [[nodiscard]] std::vector<LatencyBin> octaves() const;
    /// Those that have come since an earlier moment of the same histogram.
    [[nodiscard]] LatencyCounts since(const LatencyCounts& earlier) const;

private:
    friend class LatencyHistogram;
    static constexpr int kPerOctave = 24;
    static constexpr int kBuckets = 30 * kPerOctave;

    std::array<std::uint32_t, kBuckets> counts_{};
};

/// Durations counted in buckets of 3 % width, from a microsecond's tenth to a minute. One thread adds, any thread
/// reads; adding costs a few nanoseconds.
class LatencyHistogram {
public:
    void add(double microseconds) {
        count(bucketOf(microseconds)).fetch_add(1, std::memory_order_relaxed);
        if (microseconds > largest_.load(std::memory_order_relaxed)) {
            largest_.store(microseconds, std::memory_order_relaxed);
        }
    }

    /// The duration that a share `quantile` (0..1) of all stays below, us; 0 without entries.
    [[nodiscard]] double quantile(double quantile) const;
    [[nodiscard]] double largest() const { return largest_.load(std::memory_order_relaxed); }
    [[nodiscard]] std::uint64_t total() const { return counts().total(); }
    [[nodiscard]] LatencyCounts counts() const;
    void clear();

private:
    static constexpr int kBuckets = LatencyCounts::kBuckets;
    [[nodiscard]] static int bucketOf(double microseconds);
    [[nodiscard]] std::atomic<std::uint32_t>& count(int bucket) { return counts_[static_cast<std::size_t>(bucket)]; }

    std::array<std::atomic<std::uint32_t>, kBuckets> counts_{};
    std::atomic<double> largest_{0};
};

}  // namespace tactooth
