// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace tactooth {

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
    [[nodiscard]] std::uint64_t total() const;
    void clear();

private:
    static constexpr int kPerOctave = 24;
    static constexpr int kBuckets = 30 * kPerOctave;
    [[nodiscard]] static int bucketOf(double microseconds);
    [[nodiscard]] std::atomic<std::uint32_t>& count(int bucket) { return counts_[static_cast<std::size_t>(bucket)]; }

    std::array<std::atomic<std::uint32_t>, kBuckets> counts_{};
    std::atomic<double> largest_{0};
};

}  // namespace tactooth
