// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/process/tissue_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "assessment/agreement/failure_detection.h"
#include "assessment/cause/removal_cause.h"
#include "assessment/messages.h"
#include "collision/bvh/closest_point.h"
#include "geometry/util/parallel_for.h"
#include "session/simulation/cut_events.h"

namespace tactooth {
namespace {

constexpr double kPiece = 0.1;         // mm
constexpr double kMostPlaces = 200e3;  // in the box of the decay
constexpr double kPeriphery = 0.5;     // mm below the enamel
constexpr double kDeep = 1.0 / 3;      // of the pieces
constexpr double kCleared = 0.9;       // of the periphery: what a single speck at the end does not change
constexpr std::size_t kLeast = 10;     // pieces of a group: fewer say nothing of an order

using Layers = std::vector<const SurfacePart*>;

Layers layersOf(const LayeredTooth& tooth, MaterialRole role) {
    Layers found;
    for (const LayeredTooth::Layer& layer : tooth.layers()) {
        if (tooth.materials().hasRole(layer.material, role)) found.push_back(layer.part.get());
    }
    return found;
}

/// From the middle of one place of a grid to the next.
struct Grid {
    explicit Grid(const Layers& layers) {
        Box3 box;
        for (const SurfacePart* layer : layers) box.extend(boundingBox(layer->mesh()));
        const Vec3 size = box.sizes();
        step = std::max(kPiece, std::cbrt(size.prod() / kMostPlaces));
        first = box.min() + Vec3::Constant(step / 2);
        for (int axis = 0; axis < 3; ++axis) {
            counts[static_cast<std::size_t>(axis)] =
                std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(size[axis] / step)));
        }
    }
    [[nodiscard]] std::size_t size() const { return counts[0] * counts[1] * counts[2]; }
    [[nodiscard]] Vec3 place(std::size_t i) const {
        const std::size_t x = i % counts[0], y = i / counts[0] % counts[1], z = i / counts[0] / counts[1];
        return first + step * Vec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
    }

    double step = kPiece;
    Vec3 first = Vec3::Zero();
    std::array<std::size_t, 3> counts{1, 1, 1};
};

bool holds(const Layers& layers, const Vec3& place) {
    return std::ranges::any_of(layers, [&](const SurfacePart* each) { return contains(*each, place); });
}

/// The times of the two groups, in their order.
struct GroupTimes {
    std::vector<double> deep, periphery;
};

GroupTimes groupTimes(std::span<const DecayPiece> pieces, std::span<const std::optional<double>> times) {
    std::vector<double> distances;
    for (const DecayPiece& each : pieces) distances.push_back(each.toPulp);
    const auto third = distances.begin() + static_cast<std::ptrdiff_t>(kDeep * static_cast<double>(pieces.size()));
    GroupTimes groups;
    if (third == distances.end()) return groups;
    std::ranges::nth_element(distances, third);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (!times[i]) continue;
        if (pieces[i].toPulp < *third) {
            groups.deep.push_back(*times[i]);
        } else if (pieces[i].belowJunction <= kPeriphery) {
            groups.periphery.push_back(*times[i]);
        }
    }
    std::ranges::sort(groups.deep);
    std::ranges::sort(groups.periphery);
    return groups;
}

Measured dentinTime(const SessionTrack& track) {
    for (const TrackEvent& event : track.events()) {
        if (event.text == &cutEventText(CutEventKind::DentinReached)) return Measured::of(event.time);
    }
    return Measured::none(msg::kDentinNotReached);
}

DecayOrder noOrder(const MessageText& reason) { return {Measured::none(reason), Measured::none(reason)}; }

DecayOrder decayOrder(const LayeredTooth& tooth, const std::shared_ptr<const SessionTrack>& track) {
    if (layersOf(tooth, MaterialRole::Decay).empty()) return noOrder(msg::kNoDecayKnown);
    if (layersOf(tooth, MaterialRole::Dentin).empty()) return noOrder(msg::kNoTissueKnown);
    if (layersOf(tooth, MaterialRole::Pulp).empty()) return noOrder(msg::kNoPulpKnown);
    const std::vector<DecayPiece> pieces = decayPieces(tooth);
    std::vector<RemovedPoint> points;
    for (const DecayPiece& each : pieces) points.push_back({each.place, 1});
    TrackTooth cut(track);
    return decayOrder(pieces, removalTimes(*track, cut, points));
}

}  // namespace

std::vector<DecayPiece> decayPieces(const LayeredTooth& tooth) {
    const Layers decay = layersOf(tooth, MaterialRole::Decay), dentin = layersOf(tooth, MaterialRole::Dentin),
                 pulps = layersOf(tooth, MaterialRole::Pulp);
    if (decay.empty() || dentin.empty() || pulps.empty()) return {};
    const Grid grid(decay);
    std::vector<std::optional<DecayPiece>> found(grid.size());
    constexpr std::size_t kGrain = 256;
    parallelFor(
        grid.size(),
        [&](std::size_t i) {
            const Vec3 place = grid.place(i);
            if (!holds(decay, place) || !tooth.materials().hasRole(tooth.materialAt(place), MaterialRole::Decay))
                return;
            DecayPiece piece{place, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
            for (const SurfacePart* pulp : pulps)
                piece.toPulp = std::min(piece.toPulp, closestPoint(*pulp, place)->distance);
            for (const SurfacePart* each : dentin)
                piece.belowJunction = std::max(piece.belowJunction, -signedDistance(*each, place));
            found[i] = piece;
        },
        kGrain);
    std::vector<DecayPiece> pieces;
    for (const auto& each : found) {
        if (each) pieces.push_back(*each);
    }
    return pieces;
}

DecayOrder decayOrder(std::span<const DecayPiece> pieces, std::span<const std::optional<double>> times) {
    const GroupTimes groups = groupTimes(pieces, times);
    if (groups.deep.size() < kLeast) return noOrder(msg::kNoDeepDecayRemoved);
    if (groups.periphery.size() < kLeast) return noOrder(msg::kNoPeripheryRemoved);
    const auto share = areaUnderCurve(groups.deep, groups.periphery);
    const auto cleared = static_cast<std::size_t>(std::ceil(kCleared * static_cast<double>(groups.periphery.size())));
    const auto before = std::ranges::lower_bound(groups.deep, groups.periphery[cleared - 1]);
    const auto early = static_cast<double>(before - groups.deep.begin());
    return {Measured::of(*share), Measured::of(early / static_cast<double>(groups.deep.size()))};
}

TissueOrder tissueOrder(const LayeredTooth* tooth, const std::shared_ptr<const SessionTrack>& track) {
    TissueOrder order;
    const bool isKnown = tooth != nullptr && !tooth->layers().empty();
    const MessageText* missing = track == nullptr ? &msg::kNoSession : isKnown ? nullptr : &msg::kNoTissueKnown;
    if (missing != nullptr) {
        order.dentinTime = Measured::none(*missing);
        order.decay = noOrder(*missing);
        return order;
    }
    order.dentinTime = dentinTime(*track);
    order.decay = decayOrder(*tooth, track);
    return order;
}

}  // namespace tactooth
