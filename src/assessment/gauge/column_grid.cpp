// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/gauge/column_grid.h"

namespace tactooth {
namespace {

constexpr double kMostColumns = 4e5;         // a second of work
constexpr double kRoot = 1.324717957244746;  // of x^3 = x + 1
constexpr double kEdge =
    0.15;  // mm: the surfaces have no longer edges, so that a point of each column is near a corner

}  // namespace

ColumnGrid::ColumnGrid(const Vec3& axis, const TriangleMesh& first, const TriangleMesh& second, double spacing)
    : axis_(axis), u_(axis.unitOrthogonal()), v_(axis.cross(u_)), spacing_(spacing) {
    Eigen::AlignedBox2d box;
    for (const TriangleMesh* mesh : {&first, &second}) {
        for (const Triangle& t : mesh->triangles) {
            for (const std::uint32_t vertex : t) box.extend(Vec2(local(mesh->vertices[vertex]).head<2>()));
        }
    }
    if (box.isEmpty()) return;
    low_ = (box.min().array() - kEdge).matrix();
    const Vec2 sizes = (box.sizes().array() + 2 * kEdge).matrix();
    spacing_ = std::max(spacing, std::sqrt(sizes.prod() / kMostColumns));
    columns_ = static_cast<std::size_t>(std::ceil(sizes.x() / spacing_));
    rows_ = static_cast<std::size_t>(std::ceil(sizes.y() / spacing_));
    isCovered_.resize(columns_ * rows_);
    cover(first);
    cover(second);
}

void ColumnGrid::cover(const TriangleMesh& mesh) {
    for (const Triangle& t : mesh.triangles) {
        const Vec3 a = local(mesh.vertices[t[0]]), b = local(mesh.vertices[t[1]]), c = local(mesh.vertices[t[2]]);
        const Range range = rangeOf(a.cwiseMin(b).cwiseMin(c).head<2>(), a.cwiseMax(b).cwiseMax(c).head<2>());
        for (int j = range.bottom; j <= range.top; ++j) {
            for (int i = range.left; i <= range.right; ++i) {
                isCovered_[static_cast<std::size_t>(j) * columns_ + static_cast<std::size_t>(i)] = 1;
            }
        }
    }
}

bool ColumnGrid::covers(const Vec3& place) const {
    if (empty()) return false;
    const Vec2 at(u_.dot(place) - low_.x(), v_.dot(place) - low_.y());
    const Range range = rangeOf(at, at);
    if (range.left != range.right || range.bottom != range.top) return false;
    return isCovered(static_cast<std::size_t>(range.bottom) * columns_ + static_cast<std::size_t>(range.left));
}

bool ColumnGrid::isNear(const Vec3& middle, double radius) const {
    if (empty()) return false;
    const Vec2 at(u_.dot(middle) - low_.x(), v_.dot(middle) - low_.y());
    const Vec2 high(static_cast<double>(columns_) * spacing_, static_cast<double>(rows_) * spacing_);
    return (at.array() > -radius).all() && (at.array() < high.array() + radius).all();
}

ColumnGrid::Range ColumnGrid::rangeOf(const Vec2& low, const Vec2& high) const {
    const auto cell = [&](double at, std::size_t count) {
        return static_cast<int>(std::clamp(std::floor(at / spacing_), -1.0, static_cast<double>(count)));
    };
    return {std::max(0, cell(low.x(), columns_)), std::min(static_cast<int>(columns_) - 1, cell(high.x(), columns_)),
            std::max(0, cell(low.y(), rows_)), std::min(static_cast<int>(rows_) - 1, cell(high.y(), rows_))};
}

Vec2 ColumnGrid::lineOf(int i, int j) const {
    const auto number = static_cast<double>(static_cast<std::size_t>(j) * columns_ + static_cast<std::size_t>(i));
    const double x = 0.5 + number / kRoot, y = 0.5 + number / (kRoot * kRoot);
    return spacing_ * Vec2(i + x - std::floor(x), j + y - std::floor(y));
}

Vec3 ColumnGrid::placeOf(std::size_t column) const {
    const Vec2 at = low_ + lineOf(static_cast<int>(column % columns_), static_cast<int>(column / columns_));
    return at.x() * u_ + at.y() * v_;
}

}  // namespace tactooth
