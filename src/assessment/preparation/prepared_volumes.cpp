// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/preparation/prepared_volumes.h"

#include <algorithm>
#include <array>
#include <span>
#include <tuple>
#include <vector>

namespace tactooth {
namespace {

enum Body : std::uint8_t { kOriginal, kPrepared, kIdeal };

struct Crossing {
    std::uint32_t column;
    Body body;
    double height;  // along the axis, mm
};

/// A piece of a line on which the three surfaces stay on the same side.
struct Segment {
    double length;  // mm
    bool removed, toRemove;
};

/// Clears `flag` in each run of segments that is shorter than kCavityDepth.
void dropShortRuns(std::vector<Segment>& segments, bool Segment::*flag) {
    for (std::size_t i = 0; i < segments.size();) {
        std::size_t end = i;
        double length = 0;
        while (end < segments.size() && segments[end].*flag) length += segments[end++].length;
        if (length < kCavityDepth) {
            for (std::size_t k = i; k < end; ++k) segments[k].*flag = false;
        }
        i = std::max(end, i + 1);
    }
}

/// Adds the lengths along one line; nothing where rounding has left a surface open.
void addLine(std::span<const Crossing> line, std::vector<Segment>& segments, PreparedVolumes& sum) {
    std::array<bool, 3> inside = {};
    segments.clear();
    for (std::size_t i = 0; i < line.size(); ++i) {
        inside[line[i].body] = !inside[line[i].body];
        if (i + 1 == line.size()) break;
        const bool removed = inside[kOriginal] && !inside[kPrepared];
        const bool toRemove = inside[kOriginal] && !inside[kIdeal];
        segments.push_back({line[i + 1].height - line[i].height, removed, toRemove});
    }
    if (inside[kOriginal] || inside[kPrepared] || inside[kIdeal]) return;
    dropShortRuns(segments, &Segment::removed);
    dropShortRuns(segments, &Segment::toRemove);
    for (const Segment& segment : segments) {
        if (segment.removed && segment.toRemove) sum.common += segment.length;
        if (segment.removed && !segment.toRemove) sum.over += segment.length;
        if (!segment.removed && segment.toRemove) sum.under += segment.length;
    }
}

}  // namespace

double PreparedVolumes::dice() const {
    const double both = 2 * common + over + under;
    return both > 0 ? 2 * common / both : 0;
}

double PreparedVolumes::clearedShare() const { return common + under > 0 ? common / (common + under) : 0; }

PreparedVolumes preparedVolumes(const Preparation& preparation, const ColumnGrid& columns) {
    std::vector<Crossing> crossings;
    const auto add = [&](const SurfacePart& surface, Body body) {
        columns.forEachCrossing(surface.mesh(), [&](std::size_t column, double height) {
            if (columns.isCovered(column)) crossings.push_back({static_cast<std::uint32_t>(column), body, height});
        });
    };
    add(*preparation.original, kOriginal);
    add(*preparation.prepared, kPrepared);
    add(*preparation.ideal, kIdeal);
    std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
        return std::tie(a.column, a.height, a.body) < std::tie(b.column, b.height, b.body);
    });
    PreparedVolumes sum;
    std::vector<Segment> segments;
    for (std::size_t i = 0; i < crossings.size();) {
        std::size_t end = i;
        while (end < crossings.size() && crossings[end].column == crossings[i].column) ++end;
        addLine(std::span(crossings).subspan(i, end - i), segments, sum);
        i = end;
    }
    for (double* volume : {&sum.common, &sum.over, &sum.under}) *volume *= columns.area();
    return sum;
}

}  // namespace tactooth
