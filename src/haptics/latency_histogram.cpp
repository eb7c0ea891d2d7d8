// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/latency_histogram.h"

#include <algorithm>
#include <cmath>

namespace tactooth {
namespace {

constexpr double kSmallest = 0.1;  // us: nothing that is measured here is shorter

}  // namespace

int LatencyHistogram::bucketOf(double microseconds) {
    if (!(microseconds > kSmallest)) return 0;
    return static_cast<int>(std::min(kBuckets - 1.0, std::log2(microseconds / kSmallest) * kPerOctave));
}

std::uint64_t LatencyHistogram::total() const {
    std::uint64_t sum = 0;
    for (const auto& count : counts_) sum += count.load(std::memory_order_relaxed);
    return sum;
}

double LatencyHistogram::quantile(double quantile) const {
    const std::uint64_t all = total();
    if (all == 0) return 0;
    const auto wanted = static_cast<std::uint64_t>(std::max(1.0, std::ceil(quantile * static_cast<double>(all))));
    std::uint64_t below = 0;
    for (int bucket = 0; bucket < kBuckets; ++bucket) {
        below += counts_[static_cast<std::size_t>(bucket)].load(std::memory_order_relaxed);
        if (below >= wanted) return std::min(largest(), kSmallest * std::exp2((bucket + 1.0) / kPerOctave));
    }
    return largest();
}

void LatencyHistogram::clear() {
    for (auto& count : counts_) count.store(0, std::memory_order_relaxed);
    largest_.store(0, std::memory_order_relaxed);
}

}  // namespace tactooth
