// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/preparation/surface_deviation.h"

#include <algorithm>
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

using Corners = std::array<Vec3, 3>;

class Sampler {
public:
    Sampler(const Preparation& preparation, const ColumnGrid& columns) : all_(preparation), columns_(columns) {}

    [[nodiscard]] Sums sumsOf(std::size_t triangle) const {
        const TriangleMesh& mesh = all_.prepared->mesh();
        Sums sums;
        divide({mesh.corner(triangle, 0), mesh.corner(triangle, 1), mesh.corner(triangle, 2)}, sums);
        return sums;
    }

private:
    /// Halves the longest edge until it is short.
    void divide(const Corners& corners, Sums& sums) const {
        if (isUnchanged(corners)) return;
        int longest = 0;
        double length = 0;
        for (int i = 0; i < 3; ++i) {
            const double edge =
                (corners[static_cast<std::size_t>(i + 1) % 3] - corners[static_cast<std::size_t>(i)]).norm();
            if (edge > length) {
                length = edge;
                longest = i;
            }
        }
        if (length <= kEdge) return add(corners, sums);
        const Vec3& a = corners[static_cast<std::size_t>(longest)];
        const Vec3& b = corners[static_cast<std::size_t>(longest + 1) % 3];
        const Vec3& c = corners[static_cast<std::size_t>(longest + 2) % 3];
        const Vec3 half = (a + b) / 2;
        divide({a, half, c}, sums);
        divide({half, b, c}, sums);
    }

    /// Whether the whole triangle lies near both the uncut and the ideal surface: nobody has cut there or should have.
    /// The distance to a surface is 1-Lipschitz.
    [[nodiscard]] bool isUnchanged(const Corners& corners) const {
        const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3;
        double radius = 0;
        for (const Vec3& corner : corners) radius = std::max(radius, (corner - middle).norm());
        if (radius >= kCavityDepth) return isFar(middle, radius);
        const double left = kCavityDepth - radius;
        return closestPoint(*all_.original, middle, left) && closestPoint(*all_.ideal, middle, left);
    }

    /// Whether the triangle lies wholly beside the columns.
    [[nodiscard]] bool isFar(const Vec3& middle, double radius) const { return !columns_.isNear(middle, radius); }

    void add(const Corners& corners, Sums& sums) const {
        const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3;
        if (!columns_.covers(middle)) return;
        const bool isCut = signedDistance(*all_.original, middle) < -kCavityDepth;
        if (!isCut && signedDistance(*all_.ideal, middle) <= kCavityDepth) return;
        Vec3 distance;  // at the corners, to the ideal surface
        for (int i = 0; i < 3; ++i) distance[i] = signedDistance(*all_.ideal, corners[static_cast<std::size_t>(i)]);
        const double area = (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm() / 2;
        sums.area += area;
        sums.signedSum += area * distance.sum() / 3;
        sums.squares += area * (distance.squaredNorm() + distance.sum() * distance.sum()) / 12;  // of a linear function
        addBands(distance, area, sums);
        if (!isCut) return;
        for (int i = 0; i < 3; ++i) {
            if (-distance[i] <= sums.deepest) continue;
            sums.deepest = -distance[i];
            sums.place = corners[static_cast<std::size_t>(i)];
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
};

}  // namespace

SurfaceDeviation surfaceDeviation(const Preparation& preparation, const ColumnGrid& columns) {
    const Sampler sampler(preparation, columns);
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
