// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/relief_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tactooth::test {
namespace {

constexpr double kNone = -std::numeric_limits<double>::infinity();

struct Place {
    double u, v, height;
};

/// The height there, linear in `u` between the middles of cells: a place and its mirror image lie differently in their
/// cells.
std::optional<double> between(const ReliefMap& map, double u, double v) {
    const double from = map.box().min().x() + ReliefMap::kCell / 2;
    const double cell = std::floor((u - from) / ReliefMap::kCell), low = from + cell * ReliefMap::kCell;
    const auto a = map.at(low, v), b = map.at(low + ReliefMap::kCell, v);
    if (!a || !b) return std::nullopt;
    return std::lerp(*a, *b, (u - low) / ReliefMap::kCell);
}

/// What the best paraboloid of revolution leaves of the heights.
std::vector<Place> withoutParaboloid(std::vector<Place> places) {
    const auto termsOf = [](const Place& p) { return Eigen::Vector4d(1, p.u, p.v, p.u * p.u + p.v * p.v); };
    Eigen::Matrix4d squares = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (const Place& p : places) {
        const Eigen::Vector4d terms = termsOf(p);
        squares += terms * terms.transpose();
        right += p.height * terms;
    }
    const Eigen::Vector4d fit = squares.ldlt().solve(right);
    for (Place& p : places) p.height -= fit.dot(termsOf(p));
    return places;
}

}  // namespace

ReliefMap::ReliefMap(const TriangleMesh& mesh, int u, int v, int axis, double sign) : sign_(sign) {
    for (const Vec3f& vertex : mesh.vertices) box_.extend(Vec2(vertex[u], vertex[v]));
    columns_ = static_cast<int>(box_.sizes().x() / kCell) + 1;
    rows_ = static_cast<int>(box_.sizes().y() / kCell) + 1;
    heights_.assign(static_cast<std::size_t>(columns_ * rows_), kNone);
    const auto turned = [&](const Vec3& p) { return Vec3(p[u], p[v], sign * p[axis]); };
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        add(turned(mesh.corner(i, 0)), turned(mesh.corner(i, 1)), turned(mesh.corner(i, 2)));
    }
}

void ReliefMap::add(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 normal = (b - a).cross(c - a);
    if (normal.z() == 0) return;
    const Vec3 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    const auto columnOf = [&](double u) { return (u - box_.min().x()) / kCell - 0.5; };
    const auto rowOf = [&](double v) { return (v - box_.min().y()) / kCell - 0.5; };
    const int lastColumn = std::min(columns_ - 1, static_cast<int>(std::floor(columnOf(high.x()))));
    const int lastRow = std::min(rows_ - 1, static_cast<int>(std::floor(rowOf(high.y()))));
    const auto side = [](const Vec3& from, const Vec3& to, const Vec3& p) {
        return (to.x() - from.x()) * (p.y() - from.y()) - (to.y() - from.y()) * (p.x() - from.x());
    };
    const double turn = normal.z() > 0 ? 1 : -1;
    for (int j = std::max(0, static_cast<int>(std::ceil(rowOf(low.y())))); j <= lastRow; ++j) {
        for (int i = std::max(0, static_cast<int>(std::ceil(columnOf(low.x())))); i <= lastColumn; ++i) {
            Vec3 p(box_.min().x() + (i + 0.5) * kCell, box_.min().y() + (j + 0.5) * kCell, 0);
            if (turn * side(a, b, p) < 0 || turn * side(b, c, p) < 0 || turn * side(c, a, p) < 0) continue;
            const double height = a.z() - (normal.x() * (p.x() - a.x()) + normal.y() * (p.y() - a.y())) / normal.z();
            double& cell = heights_[cellOf(i, j)];
            cell = std::max(cell, height);
        }
    }
}

std::optional<double> ReliefMap::at(double u, double v) const {
    const int i = static_cast<int>(std::floor((u - box_.min().x()) / kCell));
    const int j = static_cast<int>(std::floor((v - box_.min().y()) / kCell));
    if (i < 0 || j < 0 || i >= columns_ || j >= rows_) return std::nullopt;
    const double height = heights_[cellOf(i, j)];
    if (height == kNone) return std::nullopt;
    return sign_ * height;
}

double reliefDifference(const ReliefMap& a, const ReliefMap& b, const Eigen::AlignedBox2d& where) {
    std::vector<Place> places;
    for (double v = where.min().y(); v <= where.max().y(); v += ReliefMap::kCell) {
        for (double u = where.min().x(); u <= where.max().x(); u += ReliefMap::kCell) {
            const auto one = a.at(u, v), other = b.at(u, v);
            if (one && other) places.push_back({u, v, *one - *other});
        }
    }
    places = withoutParaboloid(std::move(places));
    double square = 0;
    for (const Place& place : places) square += place.height * place.height;
    return std::sqrt(square / static_cast<double>(places.size()));
}

double mirrorCorrelation(const ReliefMap& map, double from, double to) {
    const double middle = map.box().center().x(), half = map.box().sizes().x() / 2;
    std::vector<Place> places;  // a place and its mirror image follow each other
    for (double v = from; v <= to; v += ReliefMap::kCell) {
        for (double u = ReliefMap::kCell / 2; u < half; u += ReliefMap::kCell) {
            const auto plus = between(map, middle + u, v), minus = between(map, middle - u, v);
            if (!plus || !minus) continue;
            places.push_back({u, v, *plus});
            places.push_back({-u, v, *minus});
        }
    }
    places = withoutParaboloid(std::move(places));
    double product = 0, square = 0;
    for (std::size_t i = 0; i + 1 < places.size(); i += 2) {
        product += 2 * places[i].height * places[i + 1].height;
        square += places[i].height * places[i].height + places[i + 1].height * places[i + 1].height;
    }
    return square > 0 ? product / square : 1;
}

}  // namespace tactooth::test
