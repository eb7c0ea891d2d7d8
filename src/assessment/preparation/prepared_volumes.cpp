// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/preparation/prepared_volumes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>
#include <vector>

#include "collision/bvh/closest_point.h"

namespace tactooth {
namespace {

/// The three surfaces, then the layers of the tooth in their nesting order.
enum Body : std::uint8_t { kOriginal, kPrepared, kIdeal, kFirstLayer };

struct Crossing {
    std::uint32_t column;
    std::uint8_t body;
    double height;  // along the axis, mm
};

/// A piece of a line on which all surfaces stay on the same side.
struct Segment {
    double low, length;  // along the axis, mm
    bool inTooth, removed, toRemove;
    MaterialRole tissue;
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

/// Adds the lengths along lines.
class LineSums {
public:
    /// `columns`: of the lines, for those that ask for the volume beyond the tolerance; null: nobody does.
    LineSums(const Preparation& preparation, const ColumnGrid* columns) : preparation_(preparation), columns_(columns) {
        if (preparation.tooth == nullptr) return;
        for (const LayeredTooth::Layer& layer : preparation.tooth->layers()) {
            tissues_.push_back(preparation.tooth->materials()[layer.material].role);
        }
    }

    /// Nothing where rounding has left a surface open.
    void add(std::span<const Crossing> line) {
        inside_.assign(kFirstLayer + tissues_.size(), 0);
        segments_.clear();
        for (std::size_t i = 0; i < line.size(); ++i) {
            inside_[line[i].body] ^= 1U;
            if (i + 1 == line.size()) break;
            const bool inTooth = inside_[kOriginal] != 0;
            segments_.push_back({.low = line[i].height,
                                 .length = line[i + 1].height - line[i].height,
                                 .inTooth = inTooth,
                                 .removed = inTooth && inside_[kPrepared] == 0,
                                 .toRemove = inTooth && inside_[kIdeal] == 0,
                                 .tissue = inTooth ? tissueAt(line, i) : MaterialRole::None});
        }
        if (std::ranges::any_of(inside_, [](std::uint8_t each) { return each != 0; })) return;
        dropShortRuns(segments_, &Segment::removed);
        dropShortRuns(segments_, &Segment::toRemove);
        for (const Segment& segment : segments_) {
            add(segment);
            if (columns_ != nullptr && segment.removed && !segment.toRemove)
                sum_.beyond += lengthBeyond(line.front().column, segment);
        }
    }

    [[nodiscard]] PreparedVolumes times(double area) const {
        PreparedVolumes volumes = sum_;
        for (double* each : {&volumes.common, &volumes.over, &volumes.under, &volumes.beyond}) *each *= area;
        for (auto& each : volumes.tissues)
            each = {each.removed * area, each.over * area, each.under * area, each.kept * area};
        return volumes;
    }

private:
    void add(const Segment& segment) {
        if (segment.removed && segment.toRemove) sum_.common += segment.length;
        if (segment.removed && !segment.toRemove) sum_.over += segment.length;
        if (!segment.removed && segment.toRemove) sum_.under += segment.length;
        if (!segment.inTooth) return;
        PreparedVolumes::Tissue& tissue = sum_.tissues[static_cast<std::size_t>(segment.tissue)];
        (segment.removed ? tissue.removed : tissue.kept) += segment.length;
        if (segment.removed && !segment.toRemove) tissue.over += segment.length;
        if (!segment.removed && segment.toRemove) tissue.under += segment.length;
    }

    /// How much of a segment lies farther from the ideal surface than the tolerance. The distance to a surface changes
    /// no faster than the place, so that each distance says how far nothing changes.
    [[nodiscard]] double lengthBeyond(std::uint32_t column, const Segment& segment) const {
        constexpr double kStep = 0.004;  // mm: much finer than a tolerance
        double beyond = 0;
        for (double at = 0; at < segment.length;) {
            const double depth = -signedDistance(*preparation_.ideal, columns_->placeAt(column, segment.low + at));
            const double clear = depth - preparation_.tolerance;
            const double step = std::min(std::max(std::abs(clear), kStep), segment.length - at);
            if (clear > 0) beyond += std::min(step, clear);
            at += step;
        }
        return beyond;
    }

    /// What the tooth is made of behind crossing `at`. In a gap between layers it is the one that is nearest along the
    /// line.
    [[nodiscard]] MaterialRole tissueAt(std::span<const Crossing> line, std::size_t at) const {
        for (std::size_t layer = tissues_.size(); layer-- > 0;) {
            if (inside_[kFirstLayer + layer] != 0) return tissues_[layer];
        }
        const double middle = (line[at].height + line[at + 1].height) / 2;
        double nearest = std::numeric_limits<double>::infinity();
        MaterialRole tissue = MaterialRole::None;
        for (const Crossing& each : line) {
            const double distance = std::abs(each.height - middle);
            if (each.body < kFirstLayer || distance >= nearest) continue;
            nearest = distance;
            tissue = tissues_[each.body - kFirstLayer];
        }
        return tissue;
    }

    const Preparation& preparation_;
    const ColumnGrid* columns_;
    std::vector<MaterialRole> tissues_;  // of the layers
    std::vector<std::uint8_t> inside_;
    std::vector<Segment> segments_;
    PreparedVolumes sum_;  // mm
};

}  // namespace

double PreparedVolumes::dice() const {
    const double both = 2 * common + over + under;
    return both > 0 ? 2 * common / both : 0;
}

double PreparedVolumes::clearedShare() const { return common + under > 0 ? common / (common + under) : 0; }

PreparedVolumes preparedVolumes(const Preparation& preparation, const ColumnGrid& columns, bool hasBeyond) {
    std::vector<Crossing> crossings;
    const auto add = [&](const SurfacePart& surface, std::size_t body) {
        columns.forEachCrossing(surface.mesh(), [&](std::size_t column, double height) {
            if (!columns.isCovered(column)) return;
            crossings.push_back({static_cast<std::uint32_t>(column), static_cast<std::uint8_t>(body), height});
        });
    };
    add(*preparation.original, kOriginal);
    add(*preparation.prepared, kPrepared);
    add(*preparation.ideal, kIdeal);
    if (preparation.tooth != nullptr) {
        const auto& layers = preparation.tooth->layers();
        for (std::size_t i = 0; i < layers.size(); ++i) add(*layers[i].part, kFirstLayer + i);
    }
    std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
        return std::tie(a.column, a.height, a.body) < std::tie(b.column, b.height, b.body);
    });
    LineSums sums(preparation, hasBeyond ? &columns : nullptr);
    for (std::size_t i = 0; i < crossings.size();) {
        std::size_t end = i;
        while (end < crossings.size() && crossings[end].column == crossings[i].column) ++end;
        sums.add(std::span(crossings).subspan(i, end - i));
        i = end;
    }
    return sums.times(columns.area());
}

}  // namespace tactooth
