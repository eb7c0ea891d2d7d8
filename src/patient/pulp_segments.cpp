// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "patient/pulp_segments.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/util/disjoint_sets.h"
#include "geometry/util/parallel_for.h"

namespace tactooth {
namespace {

constexpr double kGrid = 0.4;         // mm, within a section
constexpr double kSectionStep = 0.5;  // mm
constexpr double kWall = 0.5;         // mm of hard tissue around the pulp, at least
constexpr double kLeastDepth = 0.65;  // mm: a shallower point has no room for a canal
constexpr double kFloor = 2;          // mm that the floor of the chamber is above the furcation
constexpr double kApex = 0.7;         // mm from the root's tip to the end of the canal (apical constriction 0.5 to 1)

// Shares of the inscribed circle that the pulp fills: a chamber is about 30 % as wide as the neck, a canal starts with
// 25 % and ends with 15 % of its root.
constexpr double kChamber = 0.3, kCanalTop = 0.25, kCanalEnd = 0.15;
constexpr double kThinnest = 0.2;  // mm, radius

/// A point where a section is deepest.
struct Node {
    Vec3 middle;
    double depth;
    int above;                                                       // connected node of the section above; -1: none
    int branches = 0;                                                // connected nodes below
    double toBifurcation = std::numeric_limits<double>::infinity();  // mm down to its bifurcation
};

/// One section as a grid of depths.
class Section {
public:
    Section(const DepthField& depth, const Box3& box, double z)
        : low_(box.min()),
          columns_(static_cast<int>(std::ceil(box.sizes().x() / kGrid)) + 1),
          rows_(static_cast<int>(std::ceil(box.sizes().y() / kGrid)) + 1),
          z_(z),
          depths_(static_cast<std::size_t>(columns_) * rows_) {
        parallelFor(
            depths_.size(), [&](std::size_t i) { depths_[i] = depth(place(i)); }, 64);
    }

    /// The centre of each region deeper than kWall that is deep enough somewhere.
    [[nodiscard]] std::vector<Node> nodes() const {
        DisjointSets islands(depths_.size());
        for (int row = 0; row < rows_; ++row) {
            for (int column = 0; column < columns_; ++column) {
                const std::size_t here = number(column, row);
                if (depths_[here] < kWall) continue;
                if (column > 0 && depths_[here - 1] >= kWall) join(islands, here, here - 1);
                if (row > 0 && depths_[here - columns_] >= kWall) join(islands, here, here - columns_);
            }
        }
        std::vector<double> weights(depths_.size(), 0), deepest(depths_.size(), 0);
        std::vector<Vec3> sums(depths_.size(), Vec3::Zero());
        for (std::size_t i = 0; i < depths_.size(); ++i) {
            if (depths_[i] < kWall) continue;
            const std::uint32_t island = islands.find(static_cast<std::uint32_t>(i));
            const double weight = std::pow(depths_[i], 4);  // the deepest points count, and neighbours smooth them
            weights[island] += weight;
            sums[island] += weight * place(i);
            deepest[island] = std::max(deepest[island], depths_[i]);
        }
        std::vector<Node> nodes;
        for (std::size_t i = 0; i < depths_.size(); ++i) {
            if (deepest[i] >= kLeastDepth) nodes.push_back({sums[i] / weights[i], deepest[i], -1});
        }
        return nodes;
    }

private:
    static void join(DisjointSets& islands, std::size_t a, std::size_t b) {
        islands.join(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
    }
    [[nodiscard]] std::size_t number(int column, int row) const {
        return static_cast<std::size_t>(row) * columns_ + column;
    }
    [[nodiscard]] Vec3 place(std::size_t i) const {
        const auto column = static_cast<double>(i % columns_), row = static_cast<double>(i / columns_);
        return {low_.x() + kGrid * column, low_.y() + kGrid * row, z_};
    }

    Vec3 low_;
    int columns_, rows_;
    double z_;
    std::vector<double> depths_;
};

/// The node of the section above that is nearest to `node`; -1 if none is near.
int nearestAbove(const Node& node, const std::vector<Node>& all, std::size_t begin, std::size_t end) {
    constexpr double kReach = 6;  // mm: the centre of a wide molar's trunk may be that far from a root's
    int nearest = -1;
    double within = kReach;
    for (std::size_t i = begin; i < end; ++i) {
        const double distance = (all[i].middle - node.middle).norm();
        if (distance < within) nearest = static_cast<int>(i), within = distance;
    }
    return nearest;
}

double radiusAt(const Node& node, double bottom) {
    const double down = std::clamp(node.middle.z() / std::min(bottom, -1.0), 0.0, 1.0);
    const double part = node.middle.z() > -1 ? kChamber : kCanalTop + (kCanalEnd - kCanalTop) * down;
    return std::max(part * node.depth, kThinnest);
}

/// Lower nodes come later, so that one pass back finds the distance of each to the next bifurcation below.
void findBifurcations(std::vector<Node>& nodes) {
    for (std::size_t i = nodes.size(); i-- > 0;) {
        if (nodes[i].branches > 1) nodes[i].toBifurcation = 0;
        if (nodes[i].above < 0) continue;
        Node& above = nodes[nodes[i].above];
        above.toBifurcation = std::min(above.toBifurcation, nodes[i].toBifurcation + kSectionStep);
    }
}

std::vector<PulpSegment> segmentsOf(const std::vector<Node>& nodes, double bottom) {
    std::vector<PulpSegment> segments;
    const auto isFloor = [&](int i) { return nodes[i].toBifurcation < kFloor && nodes[i].above >= 0; };
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (isFloor(static_cast<int>(i)) || nodes[i].above < 0) continue;
        int above = nodes[i].above;
        while (isFloor(above)) above = nodes[above].above;
        segments.push_back(
            {nodes[i].middle, nodes[above].middle, radiusAt(nodes[i], bottom), radiusAt(nodes[above], bottom)});
    }
    return segments;
}

}  // namespace

std::vector<PulpSegment> pulpSegments(const DepthField& depth, const Box3& box,
                                      const std::function<bool(double)>& progress) {
    // The roof of the chamber is at about half of the crown's height: the round end of the uppermost segment reaches
    // it.
    const double top = 0.3 * box.max().z();
    const double bottom = box.min().z() + kApex;
    std::vector<Node> nodes;
    std::size_t aboveBegin = 0;
    for (double z = top; z > bottom; z -= kSectionStep) {
        if (progress && !progress((top - z) / (top - bottom))) return {};
        const std::size_t begin = nodes.size();
        for (Node node : Section(depth, box, z).nodes()) {
            node.above = nearestAbove(node, nodes, aboveBegin, begin);
            if (node.above < 0 && begin > 0) continue;  // a bulge beside the main sections of the tooth
            if (node.above >= 0) ++nodes[node.above].branches;
            nodes.push_back(node);
        }
        aboveBegin = begin;
        if (nodes.size() == begin && begin > 0) break;
    }
    findBifurcations(nodes);
    return segmentsOf(nodes, bottom);
}

}  // namespace tactooth
