// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/qp3.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/util/assert.h"
#include "geometry/util/pose.h"

// Incremental solution of an LP-type problem: R. Seidel, "Small-Dimensional Linear Programming and Convex Hulls Made
// Easy", Discrete & Computational Geometry 6, 1991; J. Matousek, M. Sharir, E. Welzl, "A Subexponential Bound for
// Linear Programming", Algorithmica 16, 1996 (which shows that the nearest point of a polyhedron is such a problem).
// Half-spaces are added one by one. One that excludes the present solution must be active in the new solution, so the
// search continues in its plane, then in a line. Differs from the papers: the order is not random, since the caller
// adds the most violated half-space last.

namespace tactooth {
namespace {

constexpr double kParallel = 1e-10;  // sine of the angle below which two planes count as parallel

class Search {
public:
    Search(std::span<const HalfSpace> halfSpaces, const Vec3& target, double tolerance)
        : halfSpaces_(halfSpaces), target_(target), tolerance_(tolerance) {}

    [[nodiscard]] std::optional<Vec3> inSpace() {
        Vec3 point = target_;
        for (int i = 0; i < static_cast<int>(halfSpaces_.size()); ++i) {
            if (!violates(i, point)) continue;
            const std::optional<Vec3> onPlane = inPlane(i);
            if (!onPlane) return std::nullopt;
            point = *onPlane;
        }
        return point;
    }

    [[nodiscard]] std::span<const int> active() const {
        return {active_.data(), static_cast<std::size_t>(activeCount_)};
    }

private:
    [[nodiscard]] bool violates(int i, const Vec3& point) const {
        return halfSpaces_[i].normal.dot(point) < halfSpaces_[i].offset - tolerance_;
    }

    /// Nearest point on plane `i` subject to the half-spaces before it.
    [[nodiscard]] std::optional<Vec3> inPlane(int i) {
        const HalfSpace& plane = halfSpaces_[i];
        TACTOOTH_ASSERT(isUnit(plane.normal));
        Vec3 point = target_ + (plane.offset - plane.normal.dot(target_)) * plane.normal;
        setActive({i});
        for (int j = 0; j < i; ++j) {
            if (!violates(j, point)) continue;
            const std::optional<Vec3> onLine = inLine(i, j);
            if (!onLine) return std::nullopt;
            point = *onLine;
        }
        return point;
    }

    /// Nearest point on the line common to planes `i` and `j` subject to the half-spaces before `j`.
    [[nodiscard]] std::optional<Vec3> inLine(int i, int j) {
        const HalfSpace& first = halfSpaces_[i];
        const HalfSpace& second = halfSpaces_[j];
        const Vec3 direction = first.normal.cross(second.normal);
        const double sine = direction.squaredNorm();
        if (sine < kParallel * kParallel) return std::nullopt;  // opposed planes: an empty slab
        const Vec3 along = direction / std::sqrt(sine);
        const Vec3 base =
            (first.offset * second.normal.cross(direction) + second.offset * direction.cross(first.normal)) / sine;
        double low = -std::numeric_limits<double>::infinity();
        double high = std::numeric_limits<double>::infinity();
        int lowIndex = -1;
        int highIndex = -1;
        for (int k = 0; k < j; ++k) {
            const double slope = halfSpaces_[k].normal.dot(along);
            const double rest = halfSpaces_[k].offset - halfSpaces_[k].normal.dot(base);
            if (std::abs(slope) < kParallel) {
                if (rest > tolerance_) return std::nullopt;
                continue;
            }
            if (const double bound = rest / slope; slope > 0 && bound > low) {
                low = bound, lowIndex = k;
            } else if (slope < 0 && bound < high) {
                high = bound, highIndex = k;
            }
        }
        if (low > high + tolerance_) return std::nullopt;
        const double wanted = (target_ - base).dot(along);
        const double chosen = std::max(low, std::min(wanted, high));
        setActive({i, j});
        TACTOOTH_ASSERT(chosen == wanted || (chosen == low ? lowIndex : highIndex) >= 0);
        if (chosen != wanted) active_[activeCount_++] = chosen == low ? lowIndex : highIndex;
        return base + chosen * along;
    }

    void setActive(std::initializer_list<int> indices) {
        std::copy(indices.begin(), indices.end(), active_.begin());
        activeCount_ = static_cast<int>(indices.size());
    }

    std::span<const HalfSpace> halfSpaces_;
    Vec3 target_;
    double tolerance_;
    std::array<int, 3> active_{};
    int activeCount_ = 0;
};

/// Multipliers of the active planes: the least-squares solution of sum(multiplier * normal) = push, never negative.
void solveMultipliers(Qp3Result& result, std::span<const HalfSpace> halfSpaces, const Vec3& push) {
    Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> normals(3, result.activeCount);
    for (int i = 0; i < result.activeCount; ++i) normals.col(i) = halfSpaces[result.active[i]].normal;
    const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3> gram = normals.transpose() * normals;
    const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> multiplier =
        gram.ldlt().solve(Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>(normals.transpose() * push));
    for (int i = 0; i < result.activeCount; ++i) result.multiplier[i] = std::max(0.0, multiplier[i]);
}

}  // namespace

Qp3Result solveQp3(std::span<const HalfSpace> halfSpaces, const Vec3& target, double tolerance) {
    TACTOOTH_ASSERT(target.allFinite());
    TACTOOTH_ASSERT(tolerance >= 0);
    Search search(halfSpaces, target, tolerance);
    Qp3Result result;
    const std::optional<Vec3> point = search.inSpace();
    if (!point) return result;
    result.feasible = true;
    result.point = *point;
    result.activeCount = static_cast<int>(search.active().size());
    TACTOOTH_ASSERT(result.activeCount <= 3);
    std::copy(search.active().begin(), search.active().end(), result.active.begin());
    if (result.activeCount > 0) solveMultipliers(result, halfSpaces, result.point - target);
    return result;
}

}  // namespace tactooth
