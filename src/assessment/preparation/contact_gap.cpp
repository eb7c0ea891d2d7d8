// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/preparation/contact_gap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "assessment/messages.h"
#include "collision/bvh/closest_point.h"
#include "geometry/util/parallel_for.h"

namespace tactooth {
namespace {

constexpr double kFacing = 0.5;     // cosine: a proximal outside faces its side within 60 degrees
constexpr double kNearSide = 1.5;   // mm from the outermost place of the tooth on that side: inner slopes lie farther
constexpr double kLeastMargin = 1;  // mm of margin on the outside: less is no box
constexpr double kReach = 3;        // mm: a tooth farther away is not beside
constexpr std::size_t kGrain = 64;  // distances: about half a millisecond

/// The part of a margin that lies on the outside of the tooth toward one side: places on the uncut surface, mm.
struct BoxMargin {
    std::vector<Vec3> places;
    double length = 0;  // mm

    [[nodiscard]] bool isBox() const { return length >= kLeastMargin; }
};

BoxMargin marginToward(const CavityWalls& walls, const SurfacePart& original, const Vec3& side) {
    double outermost = -std::numeric_limits<double>::infinity();
    for (const Vec3f& vertex : original.mesh().vertices)
        outermost = std::max(outermost, side.dot(vertex.cast<double>()));
    std::vector<Vec3> outside(walls.rim.size());
    std::vector<std::uint8_t> isOn(walls.rim.size());
    parallelFor(
        walls.rim.size(),
        [&](std::size_t i) {
            const Vec3 from = walls.mesh.vertices[walls.rim[i][0]].cast<double>();
            const Vec3 to = walls.mesh.vertices[walls.rim[i][1]].cast<double>();
            const auto near = closestPoint(original, (from + to) / 2);
            if (!near) return;
            outside[i] = near->point;
            const Vec3 normal = original.mesh().areaVector(near->triangle).stableNormalized();
            isOn[i] = normal.dot(side) > kFacing && side.dot(near->point) > outermost - kNearSide ? 1 : 0;
        },
        kGrain);
    BoxMargin margin;
    for (std::size_t i = 0; i < walls.rim.size(); ++i) {
        if (isOn[i] == 0) continue;
        margin.places.push_back(outside[i]);
        const auto& [from, to] = walls.rim[i];
        margin.length += (walls.mesh.vertices[to] - walls.mesh.vertices[from]).cast<double>().norm();
    }
    return margin;
}

/// The gingival, the buccal and the lingual margin.
using Sides = std::array<Measured, 3>;

/// The margin next to a place: of the rectangle around the whole margin, as seen from the side, the nearest edge. It is
/// open toward the occlusal side.
struct MarginFrame {
    MarginFrame(const BoxMargin& margin, const DentalDirections& to) : up(to.axis), buccal(to.buccal) {
        for (const Vec3& place : margin.places) {
            lowest = std::min(lowest, up.dot(place));
            left = std::min(left, buccal.dot(place));
            right = std::max(right, buccal.dot(place));
        }
    }

    [[nodiscard]] std::size_t sideOf(const Vec3& place) const {
        const std::array distances = {up.dot(place) - lowest, right - buccal.dot(place), buccal.dot(place) - left};
        return static_cast<std::size_t>(std::ranges::min_element(distances) - distances.begin());
    }

    Vec3 up, buccal;
    double lowest = std::numeric_limits<double>::infinity();
    double left = lowest, right = -lowest;  // lingual and buccal end
};

/// The smallest gap at each margin; nothing where no neighbour is in reach.
Sides gapsOf(const BoxMargin& margin, const MarginFrame& frame, const SurfacePart& neighbours) {
    std::vector<double> gaps(margin.places.size());
    parallelFor(
        gaps.size(),
        [&](std::size_t i) {
            const auto near = closestPoint(neighbours, margin.places[i], kReach);
            gaps[i] = near ? near->distance : std::numeric_limits<double>::infinity();
        },
        kGrain);
    Sides least;
    least.fill(Measured::none(msg::kNoNeighbourThere));
    for (std::size_t i = 0; i < gaps.size(); ++i) {
        Measured& side = least[frame.sideOf(margin.places[i])];
        if (gaps[i] <= kReach && (!side.value || gaps[i] < *side.value)) side = Measured::at(gaps[i], margin.places[i]);
    }
    return least;
}

ContactGap all(const MessageText& reason) {
    return {Measured::none(reason), Measured::none(reason), Measured::none(reason)};
}

}  // namespace

ContactGap contactGap(const Preparation& preparation, const CutSurfaces& surfaces) {
    const DentalDirections to(preparation.axis, preparation.mesialX);
    if (surfaces.isCrown) return all(msg::kNoCavity);
    if (!to.hasMesial || !to.hasBuccal) return all(msg::kNotOcclusal);
    if (preparation.neighbours == nullptr) return all(msg::kNoNeighbourKnown);
    Sides least;
    least.fill(Measured::none(msg::kNoBox));
    for (const Vec3& side : {to.mesial, Vec3(-to.mesial)}) {
        const BoxMargin ideal = marginToward(surfaces.idealCut, *preparation.original, side);
        const BoxMargin cut = marginToward(surfaces.cut, *preparation.original, side);
        if (!ideal.isBox() && !cut.isBox()) continue;
        const BoxMargin& margin = cut.isBox() ? cut : ideal;
        Sides gaps = gapsOf(margin, MarginFrame(margin, to), *preparation.neighbours);
        for (std::size_t i = 0; i < gaps.size(); ++i) {
            if (gaps[i].value && !cut.isBox()) gaps[i] = Measured::at(0, *gaps[i].place);
            if (!least[i].value || gaps[i].value.value_or(INFINITY) < *least[i].value) least[i] = gaps[i];
        }
    }
    return {least[0], least[1], least[2]};
}

}  // namespace tactooth
