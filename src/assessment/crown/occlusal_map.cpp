// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/crown/occlusal_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/util/parallel_for.h"
#include "session/control/surface_ray.h"

namespace tactooth {
namespace {

constexpr double kGrid = 0.1;         // mm between two heights
constexpr double kEven = 0.5;         // mm: standard deviation of what evens out the slopes
constexpr double kLoweredEven = 0.3;  // the same of the lowered surface
constexpr double kSteepest = 1.5;     // slope: what is steeper is a side of the tooth
constexpr double kTurnover = 1.0;     // mm to both sides of the middle, where the reduction changes
constexpr double kAbove = 60;         // mm
constexpr double kNone = -std::numeric_limits<double>::infinity();

}  // namespace

OcclusalMap::OcclusalMap(const CrownOutline& crown, const FinishLine& line, std::shared_ptr<const SurfacePart> outer)
    : axis_(line.axis()), u_(line.across()), v_(line.aside()) {
    Eigen::AlignedBox2d box;
    for (const Vec3f& vertex : outer->mesh().vertices) {
        const Vec3 place = vertex.cast<double>();
        if (axis_.dot(place) > line.lowest()) box.extend(Vec2(u_.dot(place), v_.dot(place)));
    }
    corner_ = box.min();
    columns_ = static_cast<int>(std::ceil(box.sizes().x() / kGrid)) + 1;
    rows_ = static_cast<int>(std::ceil(box.sizes().y() / kGrid)) + 1;
    const Surface surface{.base = std::move(outer)};
    std::vector<double> uncut(static_cast<std::size_t>(columns_ * rows_), kNone);
    parallelFor(static_cast<std::size_t>(rows_), [&](std::size_t j) {
        for (int i = 0; i < columns_; ++i) {
            const Vec3 from = (corner_.x() + kGrid * i) * u_ + (corner_.y() + kGrid * static_cast<double>(j)) * v_;
            const auto hit = firstHit(surface, {from + kAbove * axis_, -axis_});
            if (hit && kAbove - *hit > line.lowest()) at(uncut, i, static_cast<int>(j)) = kAbove - *hit;
        }
    });
    double middle = 0;
    for (const Vec3& point : line.points()) middle += v_.dot(point) / static_cast<double>(line.points().size());
    std::vector<double> occlusal = uncut;
    for (int j = 0; j < rows_; ++j) {
        for (int i = 0; i < columns_; ++i) {
            if (slopeAt(uncut, i, j) > kSteepest) at(occlusal, i, j) = kNone;
        }
    }
    lower(crown, smoothed(occlusal, kEven), middle);
}

double& OcclusalMap::at(std::vector<double>& grid, int i, int j) const {
    return grid[static_cast<std::size_t>(j * columns_ + i)];
}

double OcclusalMap::at(const std::vector<double>& grid, int i, int j) const {
    return grid[static_cast<std::size_t>(std::clamp(j, 0, rows_ - 1) * columns_ + std::clamp(i, 0, columns_ - 1))];
}

/// Infinite at the border of the tooth.
double OcclusalMap::slopeAt(const std::vector<double>& grid, int i, int j) const {
    const double right = at(grid, i + 1, j), left = at(grid, i - 1, j), up = at(grid, i, j + 1),
                 down = at(grid, i, j - 1);
    if (!std::isfinite(right) || !std::isfinite(left) || !std::isfinite(up) || !std::isfinite(down)) return -kNone;
    return std::hypot(right - left, up - down) / (2 * kGrid);
}

/// The mean of the neighbours by a Gaussian curve; beside the tooth there are none.
std::vector<double> OcclusalMap::smoothed(const std::vector<double>& grid, double width) const {
    const int reach = static_cast<int>(std::ceil(3 * width / kGrid));
    std::vector<double> weights;
    for (int k = 0; k <= reach; ++k) weights.push_back(std::exp(-k * k * kGrid * kGrid / (2 * width * width)));
    std::vector<double> result = grid;
    for (const bool isAcross : {true, false}) {
        const std::vector<double> before = result;
        for (int j = 0; j < rows_; ++j) {
            for (int i = 0; i < columns_; ++i) {
                double sum = 0, all = 0;
                for (int k = -reach; k <= reach; ++k) {
                    const int x = isAcross ? i + k : i, y = isAcross ? j : j + k;
                    if (x < 0 || y < 0 || x >= columns_ || y >= rows_) continue;
                    const double height = at(before, x, y);
                    if (height == kNone) continue;
                    const double weight = weights[static_cast<std::size_t>(std::abs(k))];
                    sum += weight * height;
                    all += weight;
                }
                at(result, i, j) = all > 0 ? sum / all : kNone;
            }
        }
    }
    return result;
}

void OcclusalMap::lower(const CrownOutline& crown, const std::vector<double>& uncut, double middle) {
    std::vector<double> lowered = uncut;
    for (int j = 0; j < rows_; ++j) {
        const double aside = crown.functionalSide * (corner_.y() + kGrid * j - middle);
        const double share = std::clamp((aside / kTurnover + 1) / 2, 0.0, 1.0);
        const double depth = crown.occlusal + (crown.functional - crown.occlusal) * share * share * (3 - 2 * share);
        for (int i = 0; i < columns_; ++i) {
            if (at(uncut, i, j) == kNone) continue;
            const double slope = slopeAt(uncut, i, j);
            const double steep = std::isfinite(slope) ? std::min(slope, kSteepest) : 0;
            at(lowered, i, j) -= depth * std::sqrt(1 + steep * steep);
        }
    }
    heights_ = smoothed(lowered, kLoweredEven);
    // Beside the occlusal surface it goes on level, and the walls end it.
    while (std::ranges::find(heights_, kNone) != heights_.end()) {
        const std::vector<double> wider = smoothed(heights_, 2 * kEven);
        bool isFilled = false;
        for (std::size_t i = 0; i < heights_.size(); ++i) {
            if (heights_[i] != kNone || wider[i] == kNone) continue;
            heights_[i] = wider[i];
            isFilled = true;
        }
        if (!isFilled) break;
    }
}

RemovedBody::Depth OcclusalMap::over(const Vec3& place) const {
    const double x = std::clamp((u_.dot(place) - corner_.x()) / kGrid, 0.0, columns_ - 1.001);
    const double y = std::clamp((v_.dot(place) - corner_.y()) / kGrid, 0.0, rows_ - 1.001);
    const int i = static_cast<int>(x), j = static_cast<int>(y);
    const double right = x - i, up = y - j;
    const double a = at(heights_, i, j), b = at(heights_, i + 1, j), c = at(heights_, i, j + 1),
                 d = at(heights_, i + 1, j + 1);
    const double height = (1 - up) * ((1 - right) * a + right * b) + up * ((1 - right) * c + right * d);
    const double alongU = ((1 - up) * (b - a) + up * (d - c)) / kGrid;
    const double alongV = ((1 - right) * (c - a) + right * (d - b)) / kGrid;
    const Vec3 gradient = axis_ - alongU * u_ - alongV * v_;
    return {(axis_.dot(place) - height) / gradient.norm(), gradient.normalized()};
}

}  // namespace tactooth
