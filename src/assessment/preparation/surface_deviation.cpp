// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/preparation/surface_deviation.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "assessment/messages.h"
#include "assessment/preparation/quantile.h"
#include "collision/bvh/closest_point.h"
#include "geometry/util/parallel_for.h"

namespace tactooth {
namespace {

constexpr double kEdge = 0.1;       // mm: longest edge of a piece on which the distance is nearly linear
constexpr std::size_t kGrain = 64;  // triangles: about a millisecond
constexpr std::array kBands = {0.1, 0.2, 0.3, 0.4};  // mm: the tolerances that schools use

struct Sums {
    double area = 0, squares = 0, signedSum = 0;
    std::vector<std::pair<float, float>> parts;  // absolute distance, mm, and area
    std::array<double, kBands.size()> within = {};
    double deepest = 0;  // beyond the ideal surface, mm
    Vec3 place = Vec3::Zero();
};

/// Distances of the vertices of a mesh to a surface, each computed once: some six triangles ask for it. May be called
/// from several threads at once.
class VertexDistances {
public:
    VertexDistances(const SurfacePart& to, std::size_t vertices) : to_(to), known_(vertices) {
        for (auto& each : known_) each.store(kUnknown, std::memory_order_relaxed);
    }

    /// That of the vertex `vertex`, which is at `place`: negative inside, mm.
    [[nodiscard]] double of(std::uint32_t vertex, const Vec3& place) {
        double distance = known_[vertex].load(std::memory_order_relaxed);
        if (!std::isnan(distance)) return distance;
        distance = signedDistance(to_, place);  // two threads at once find the same
        known_[vertex].store(distance, std::memory_order_relaxed);
        return distance;
    }

private:
    static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

    const SurfacePart& to_;
    std::vector<std::atomic<double>> known_;
};

struct Corner {
    Vec3 place;
    std::optional<std::uint32_t> vertex;  // of the mesh; none where an edge was halved
};
using Corners = std::array<Corner, 3>;

Vec3 middleOf(const Corners& corners) { return (corners[0].place + corners[1].place + corners[2].place) / 3; }

class Sampler {
public:
    Sampler(const Preparation& preparation, const ColumnGrid& columns)
        : all_(preparation),
          columns_(columns),
          toIdeal_(*preparation.ideal, preparation.prepared->mesh().vertices.size()) {}

    [[nodiscard]] Sums sumsOf(std::size_t triangle) {
        const TriangleMesh& mesh = all_.prepared->mesh();
        Corners corners;
        for (int i = 0; i < 3; ++i)
            corners[static_cast<std::size_t>(i)] = {mesh.corner(triangle, i), mesh.triangles[triangle][i]};
        Sums sums;
        divide(corners, sums);
        return sums;
    }

private:
    /// Halves the longest edge until it is short.
    void divide(const Corners& corners, Sums& sums) {
        if (isUnchanged(corners)) return;
        int longest = 0;
        double length = 0;
        for (int i = 0; i < 3; ++i) {
            const double edge =
                (corners[static_cast<std::size_t>(i + 1) % 3].place - corners[static_cast<std::size_t>(i)].place)
                    .norm();
            if (edge > length) {
                length = edge;
                longest = i;
            }
        }
        if (length <= kEdge) return add(corners, sums);
        const Corner& a = corners[static_cast<std::size_t>(longest)];
        const Corner& b = corners[static_cast<std::size_t>(longest + 1) % 3];
        const Corner& c = corners[static_cast<std::size_t>(longest + 2) % 3];
        const Corner half = {(a.place + b.place) / 2, std::nullopt};
        divide({a, half, c}, sums);
        divide({half, b, c}, sums);
    }

    /// Whether the whole triangle lies near both the uncut and the ideal surface: nobody has cut there or should have.
    /// The distance to a surface is 1-Lipschitz.
    [[nodiscard]] bool isUnchanged(const Corners& corners) const {
        const Vec3 middle = middleOf(corners);
        double radius = 0;
        for (const Corner& corner : corners) radius = std::max(radius, (corner.place - middle).norm());
        if (radius >= kCavityDepth) return isFar(middle, radius);
        const double left = kCavityDepth - radius;
        return closestPoint(*all_.original, middle, left) && closestPoint(*all_.ideal, middle, left);
    }

    // Most places lie near the surface: there the side, which takes a ray, does not matter.
    [[nodiscard]] static bool isDeepIn(const SurfacePart& part, const Vec3& place) {
        return !closestPoint(part, place, kCavityDepth) && contains(part, place);
    }
    [[nodiscard]] static bool isFarOff(const SurfacePart& part, const Vec3& place) {
        return !closestPoint(part, place, kCavityDepth) && !contains(part, place);
    }

    /// Whether the triangle lies wholly beside the columns.
    [[nodiscard]] bool isFar(const Vec3& middle, double radius) const { return !columns_.isNear(middle, radius); }

    /// Signed distance of a corner to the ideal surface, mm.
    [[nodiscard]] double toIdeal(const Corner& corner) {
        return corner.vertex ? toIdeal_.of(*corner.vertex, corner.place) : signedDistance(*all_.ideal, corner.place);
    }

    void add(const Corners& corners, Sums& sums) {
        const Vec3 middle = middleOf(corners);
        if (!columns_.covers(middle)) return;
        const bool isCut = isDeepIn(*all_.original, middle);
        if (!isCut && !isFarOff(*all_.ideal, middle)) return;
        Vec3 distance;  // at the corners, to the ideal surface
        for (int i = 0; i < 3; ++i) distance[i] = toIdeal(corners[static_cast<std::size_t>(i)]);
        const double area = (corners[1].place - corners[0].place).cross(corners[2].place - corners[0].place).norm() / 2;
        sums.area += area;
        sums.signedSum += area * distance.sum() / 3;
        sums.squares += area * (distance.squaredNorm() + distance.sum() * distance.sum()) / 12;  // of a linear function
        addBands(distance, area, sums);
        if (!isCut) return;
        for (int i = 0; i < 3; ++i) {
            if (-distance[i] <= sums.deepest) continue;
            sums.deepest = -distance[i];
            sums.place = corners[static_cast<std::size_t>(i)].place;
        }
    }

    /// Takes the distance for linear, at the middles of kParts * kParts equal parts of the triangle.
    static void addBands(const Vec3& distance, double area, Sums& sums) {
        constexpr int kParts = 4;
        const double part = area / (kParts * kParts);
        for (int i = 0; i < kParts; ++i) {
            for (int j = 0; j < 2 * (kParts - i) - 1; ++j) {
                // Parts in row i stand on their base and on their tip in turn.
                const double v = (i + (j % 2 == 0 ? 1 : 2) / 3.0) / kParts;
                const double u = (j / 2 + (j % 2 == 0 ? 1 : 2) / 3.0) / kParts;
                const double here =
                    std::abs(distance[0] + u * (distance[1] - distance[0]) + v * (distance[2] - distance[0]));
                sums.parts.emplace_back(static_cast<float>(here), static_cast<float>(part));
                for (std::size_t band = 0; band < kBands.size(); ++band) {
                    if (here <= kBands[band]) sums.within[band] += part;
                }
            }
        }
    }

    const Preparation& all_;
    const ColumnGrid& columns_;
    VertexDistances toIdeal_;
};

}  // namespace

SurfaceDeviation surfaceDeviation(const Preparation& preparation, const ColumnGrid& columns) {
    Sampler sampler(preparation, columns);
    std::vector<Sums> sums(preparation.prepared->mesh().triangles.size());
    parallelFor(
        sums.size(), [&](std::size_t i) { sums[i] = sampler.sumsOf(i); }, kGrain);
    Sums all;
    for (const Sums& each : sums) {
        all.signedSum += each.signedSum;
        all.parts.insert(all.parts.end(), each.parts.begin(), each.parts.end());
        all.area += each.area;
        all.squares += each.squares;
        for (std::size_t i = 0; i < kBands.size(); ++i) all.within[i] += each.within[i];
        if (each.deepest <= all.deepest) continue;
        all.deepest = each.deepest;
        all.place = each.place;
    }
    SurfaceDeviation result;
    if (all.area == 0) {
        result.overMax = result.rms = result.mean = result.median = result.p95 = Measured::none(msg::kNothingToCompare);
        result.within.fill(result.rms);
        return result;
    }
    result.overMax = all.deepest > 0 ? Measured::at(all.deepest, all.place) : Measured::of(0);
    result.rms = Measured::of(std::sqrt(all.squares / all.area));
    result.mean = Measured::of(all.signedSum / all.area);
    std::ranges::sort(all.parts);
    const auto notExceededOn = [&](double share) {
        return Measured::of(quantileByArea(all.parts, all.area, share, &std::pair<float, float>::second).first);
    };
    result.median = notExceededOn(0.5);
    result.p95 = notExceededOn(0.95);
    for (std::size_t i = 0; i < kBands.size(); ++i) result.within[i] = Measured::of(all.within[i] / all.area);
    return result;
}

}  // namespace tactooth
