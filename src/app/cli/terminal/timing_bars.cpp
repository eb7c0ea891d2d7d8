// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/terminal/timing_bars.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

namespace tactooth {
namespace {

constexpr int kBar = 11;   // letters
constexpr int kCount = 8;  // letters: the count of an hour at 4 kHz

double heightOf(std::uint64_t count) { return std::log10(1.0 + static_cast<double>(count)); }

/// The length is in half letters, at least one. The fonts of all terminals have full and half blocks.
std::string bar(std::uint64_t count, double highest) {
    const int halves = std::max(1, static_cast<int>(std::lround(2 * kBar * heightOf(count) / highest)));
    std::string text;
    for (int i = 0; i < halves / 2; ++i) text += "█";
    if (halves % 2 == 1) text += "▌";
    return text.append(static_cast<std::size_t>(kBar - (halves + 1) / 2), ' ');
}

/// A histogram that is to be printed. Bins with the same edge have exactly the same number for it, bit by bit.
struct Column {
    std::map<double, std::uint64_t> bins;  // key: upper edge, us
    double highest = 0;

    explicit Column(const LatencyCounts& counts) {
        for (const LatencyBin& bin : counts.octaves()) {
            bins[bin.upTo] = bin.count;
            highest = std::max(highest, heightOf(bin.count));
        }
    }
    [[nodiscard]] std::string cell(double upTo) const {
        const auto found = bins.find(upTo);
        if (found == bins.end() || found->second == 0) return fmt::format("  {:{}}", "", kBar + 1 + kCount);
        return fmt::format("  {} {:>{}}", bar(found->second, highest), found->second, kCount);
    }
};

/// Removes the blanks at the end.
std::string line(std::string text) { return text.erase(text.find_last_not_of(' ') + 1) + '\n'; }

}  // namespace

std::string timingBars(std::span<const TimingBars> histograms) {
    std::vector<Column> columns;
    std::set<double> edges;
    std::string head = "below, us";
    for (const TimingBars& histogram : histograms) {
        columns.emplace_back(histogram.counts);
        for (const auto& bin : columns.back().bins) edges.insert(bin.first);
        head += fmt::format("  {:<{}}", histogram.title, kBar + 1 + kCount);
    }
    std::string text = line(head);
    for (const double upTo : edges) {
        std::string row = fmt::format("{:>9.1f}", upTo);
        for (const Column& column : columns) row += column.cell(upTo);
        text += line(row);
    }
    return text;
}

}  // namespace tactooth
