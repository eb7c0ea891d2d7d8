// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/latency_histogram.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

constexpr double kSmallest = 0.1;  // us: shorter than all that is measured here

}  // namespace

std::uint64_t LatencyCounts::total() const { return std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0}); }

double LatencyCounts::quantile(double quantile) const {
    TACTOOTH_ASSERT(quantile >= 0 && quantile <= 1);
    const std::uint64_t all = total();
    if (all == 0) return 0;
    const auto wanted = static_cast<std::uint64_t>(std::max(1.0, std::ceil(quantile * static_cast<double>(all))));
    std::uint64_t below = 0;
    int bucket = 0;
    while (bucket < kBuckets - 1 && (below += counts_[static_cast<std::size_t>(bucket)]) < wanted) ++bucket;
    return kSmallest * std::exp2((bucket + 1.0) / kPerOctave);
}

std::uint64_t LatencyCounts::between(double low, double high) const {
    const auto firstFrom = [](double microseconds) {
        return std::clamp(std::ceil(std::log2(std::max(microseconds, kSmallest) / kSmallest) * kPerOctave), 0.0,
                          static_cast<double>(kBuckets));
    };
    const auto from = static_cast<std::ptrdiff_t>(firstFrom(low));
    const auto to = std::max(from, static_cast<std::ptrdiff_t>(firstFrom(high)));
    return std::accumulate(counts_.begin() + from, counts_.begin() + to, std::uint64_t{0});
}

std::vector<LatencyBin> LatencyCounts::octaves() const {
    std::vector<LatencyBin> bins;
    for (std::size_t first = 0; first < counts_.size(); first += kPerOctave) {
        const auto from = counts_.begin() + static_cast<std::ptrdiff_t>(first);
        const std::uint64_t count = std::accumulate(from, from + kPerOctave, std::uint64_t{0});
        const double octave = static_cast<double>(first / kPerOctave);
        if (count > 0 || !bins.empty()) bins.push_back({kSmallest * std::exp2(octave + 1), count});
    }
    while (!bins.empty() && bins.back().count == 0) bins.pop_back();
    return bins;
}

LatencyCounts LatencyCounts::since(const LatencyCounts& earlier) const {
    LatencyCounts newer = *this;
    for (std::size_t i = 0; i < newer.counts_.size(); ++i) newer.counts_[i] -= earlier.counts_[i];
    return newer;
}

int LatencyHistogram::bucketOf(double microseconds) {
    if (!(microseconds > kSmallest)) return 0;
    return static_cast<int>(std::min(kBuckets - 1.0, std::log2(microseconds / kSmallest) * LatencyCounts::kPerOctave));
}

LatencyCounts LatencyHistogram::counts() const {
    LatencyCounts now;
    for (std::size_t i = 0; i < counts_.size(); ++i) now.counts_[i] = counts_[i].load(std::memory_order_relaxed);
    return now;
}

double LatencyHistogram::quantile(double quantile) const { return std::min(largest(), counts().quantile(quantile)); }

void LatencyHistogram::clear() {
    for (auto& count : counts_) count.store(0, std::memory_order_relaxed);
    largest_.store(0, std::memory_order_relaxed);
}

}  // namespace tactooth
