// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/outline/flat_outline.h"

#include <algorithm>
#include <limits>

namespace tactooth {
namespace {

using Point = FlatOutline::Point;

constexpr double kRoomStep = 0.05;  // mm between two places that are tried: a voxel

/// Positive where c lies to the left of the line from a to b.
double sideOf(const Point& a, const Point& b, const Point& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool isBetween(const Point& a, const Point& b, const Point& c) {
    return (c.array() >= a.array().min(b.array())).all() && (c.array() <= a.array().max(b.array())).all();
}

bool meet(const Point& a, const Point& b, const Point& c, const Point& d) {
    const double abc = sideOf(a, b, c), abd = sideOf(a, b, d), cda = sideOf(c, d, a), cdb = sideOf(c, d, b);
    if (abc * abd < 0 && cda * cdb < 0) return true;
    return (abc == 0 && isBetween(a, b, c)) || (abd == 0 && isBetween(a, b, d)) || (cda == 0 && isBetween(c, d, a)) ||
           (cdb == 0 && isBetween(c, d, b));
}

double distanceToEdge(const Point& a, const Point& b, const Point& p) {
    const Point along = b - a;
    const double length = along.squaredNorm();
    const double t = length > 0 ? std::clamp(along.dot(p - a) / length, 0.0, 1.0) : 0;
    return (p - a - t * along).norm();
}

}  // namespace

FlatOutline::FlatOutline(std::span<const Vec3> corners, const Vec3& outward)
    : outward_(outward), u_(outward.unitOrthogonal()), v_(outward.cross(u_)) {
    for (const Vec3& corner : corners) {
        corners_.push_back(flat(corner));
        box_.extend(corners_.back());
    }
}

/// By the number of edges to the right of it (M. Shimrat, "Algorithm 112: position of point relative to polygon",
/// Communications of the ACM 5, 1962).
bool FlatOutline::contains(const Point& point) const {
    bool inside = false;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        const Point &a = corners_[i], &b = next(i);
        if ((a.y() > point.y()) == (b.y() > point.y())) continue;
        const double x = a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
        if (point.x() < x) inside = !inside;
    }
    return inside;
}

double FlatOutline::distance(const Point& point) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < corners_.size(); ++i)
        least = std::min(least, distanceToEdge(corners_[i], next(i), point));
    return least;
}

bool FlatOutline::crossesItself() const {
    const std::size_t count = corners_.size();
    if (count < 3) return true;
    for (std::size_t i = 0; i < count; ++i) {
        if (corners_[i] == next(i)) return true;
        // A corner that folds back onto the edge before it.
        const Point before = next(i) - corners_[i], after = next(i + 1) - next(i);
        if (sideOf(corners_[i], next(i), next(i + 1)) == 0 && before.dot(after) < 0) return true;
        for (std::size_t j = i + 2; j < count; ++j) {
            const bool isBeside = i == 0 && j + 1 == count;
            if (!isBeside && meet(corners_[i], next(i), corners_[j], next(j))) return true;
        }
    }
    return false;
}

bool FlatOutline::hasRoomFor(double radius) const {
    if (corners_.size() < 3) return false;
    for (double y = box_.min().y(); y <= box_.max().y(); y += kRoomStep) {
        for (double x = box_.min().x(); x <= box_.max().x(); x += kRoomStep) {
            const Point point(x, y);
            if (contains(point) && distance(point) >= radius) return true;
        }
    }
    return false;
}

double FlatOutline::signedArea() const {
    double sum = 0;
    for (std::size_t i = 0; i < corners_.size(); ++i)
        sum += corners_[i].x() * next(i).y() - next(i).x() * corners_[i].y();
    return sum / 2;
}

std::size_t FlatOutline::edgeFor(const Point& point) const {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        const double longer = (corners_[i] - point).norm() + (next(i) - point).norm() - (next(i) - corners_[i]).norm();
        if (longer >= least) continue;
        least = longer;
        best = i;
    }
    return best;
}

}  // namespace tactooth
