// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/gauge/floor_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "geometry/util/degree.h"

// The cut surface becomes a map of heights, as one sees it along the axis. A wall that stands along the axis covers no
// place of the map, and a slope covers as much as one sees of it.

namespace tactooth {
namespace {

constexpr double kSpacing = 0.05;           // mm between two places
constexpr double kMostPlaces = 1e6;         // of the map
constexpr double kSteepest = 85 * kDegree;  // a steeper triangle is a wall, of which one sees nothing
constexpr double kFloorSlope = 30 * kDegree, kSlopingFloor = 45 * kDegree;
constexpr double kRounding = 0.3;      // mm: strip along the border with the rounded angles
constexpr double kRidgeWidth = 0.6;    // mm: of a ridge between two passes, half of a usual bur
constexpr double kRidgeHeight = 0.35;  // mm: what stands higher over the floor is a wall
constexpr double kLeastFloor = 0.05;   // mm^2, for a direction worth the name

struct Step {
    int x, y;
};
constexpr std::array kNeighbours = {Step{1, 0}, Step{-1, 0}, Step{0, 1}, Step{0, -1}};
constexpr std::array kDirections = {Step{1, 0}, Step{0, 1}, Step{1, 1}, Step{1, -1}};

/// The cut surface as seen along the axis: the lowest height over each place.
class HeightMap {
public:
    HeightMap(const TriangleMesh& cut, const Vec3& axis) : axis_(axis), u_(axis.unitOrthogonal()), v_(axis.cross(u_)) {
        Box3 box;
        for (const Triangle& t : cut.triangles) {
            for (const std::uint32_t vertex : t) box.extend(local(cut.vertices[vertex]));
        }
        if (box.isEmpty()) return;
        spacing_ = std::max(kSpacing, std::sqrt(box.sizes().x() * box.sizes().y() / kMostPlaces));
        low_ = box.min();
        columns_ = static_cast<int>(box.sizes().x() / spacing_) + 1;
        rows_ = static_cast<int>(box.sizes().y() / spacing_) + 1;
        heights_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_),
                        std::numeric_limits<double>::quiet_NaN());
        slopes_.resize(heights_.size());
        for (const Triangle& t : cut.triangles)
            add({local(cut.vertices[t[0]]), local(cut.vertices[t[1]]), local(cut.vertices[t[2]])});
    }

    [[nodiscard]] int columns() const { return columns_; }
    [[nodiscard]] int rows() const { return rows_; }
    [[nodiscard]] double spacing() const { return spacing_; }
    [[nodiscard]] std::size_t size() const { return heights_.size(); }
    [[nodiscard]] bool isIn(int x, int y) const { return x >= 0 && y >= 0 && x < columns_ && y < rows_; }
    [[nodiscard]] std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x);
    }
    /// NaN where nothing was cut.
    [[nodiscard]] double heightAt(std::size_t place) const { return heights_[place]; }
    /// Against the axis, radians.
    [[nodiscard]] double slopeAt(std::size_t place) const { return slopes_[place]; }
    [[nodiscard]] Vec3 placeAt(int x, int y) const {
        const double along = low_.x() + (x + 0.5) * spacing_, across = low_.y() + (y + 0.5) * spacing_;
        return along * u_ + across * v_ + heights_[at(x, y)] * axis_;
    }

private:
    [[nodiscard]] Vec3 local(const Vec3f& place) const {
        const Vec3 from = place.cast<double>();
        return {u_.dot(from), v_.dot(from), axis_.dot(from)};
    }

    void add(const std::array<Vec3, 3>& p) {
        const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]);
        const double slope = std::acos(std::clamp(normal.z() / std::max(normal.norm(), 1e-300), -1.0, 1.0));
        if (slope > kSteepest) return;
        const Vec3 low = p[0].cwiseMin(p[1]).cwiseMin(p[2]), high = p[0].cwiseMax(p[1]).cwiseMax(p[2]);
        const auto first = [&](int k) { return static_cast<int>(std::ceil((low[k] - low_[k]) / spacing_ - 0.5)); };
        const auto last = [&](int k) { return static_cast<int>(std::floor((high[k] - low_[k]) / spacing_ - 0.5)); };
        for (int y = std::max(0, first(1)); y <= std::min(rows_ - 1, last(1)); ++y) {
            for (int x = std::max(0, first(0)); x <= std::min(columns_ - 1, last(0)); ++x) {
                const Vec2 line(low_.x() + (x + 0.5) * spacing_, low_.y() + (y + 0.5) * spacing_);
                if (!covers(p, line)) continue;
                const double rise = normal.x() * (line.x() - p[0].x()) + normal.y() * (line.y() - p[0].y());
                take(at(x, y), std::clamp(p[0].z() - rise / normal.z(), low.z(), high.z()), slope);
            }
        }
    }

    /// An edge belongs to both of its triangles: they have the same height there.
    static bool covers(const std::array<Vec3, 3>& p, const Vec2& line) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec2 edge = (p[(i + 1) % 3] - p[i]).head<2>(), from = line - p[i].head<2>();
            if (edge.x() * from.y() - edge.y() * from.x() < -1e-9) return false;
        }
        return true;
    }

    void take(std::size_t place, double height, double slope) {
        if (heights_[place] <= height) return;
        heights_[place] = height;
        slopes_[place] = slope;
    }

    Vec3 axis_, u_, v_;
    Vec3 low_ = Vec3::Zero();  // along u_, v_ and the axis, mm
    double spacing_ = kSpacing;
    int columns_ = 0, rows_ = 0;
    std::vector<double> heights_, slopes_;
};

using Marks = std::vector<std::uint8_t>;  // 1 at the places of a HeightMap that belong to something

/// Adds the ridges and grooves that end on both sides at the floor, at nearly the same height.
class RidgeJoiner {
public:
    RidgeJoiner(const HeightMap& map, Marks& floor) : map_(map), floor_(floor) {}

    void join() {
        const Marks before = floor_;  // so that the order of the directions changes nothing
        for (const Step& step : kDirections) {
            for (int y = 0; y < map_.rows(); ++y) {
                for (int x = 0; x < map_.columns(); ++x) {
                    if (!map_.isIn(x - step.x, y - step.y)) joinLine(before, x, y, step);
                }
            }
        }
    }

private:
    /// Along one line through the map, from its border at (x, y).
    void joinLine(const Marks& before, int x, int y, const Step& step) {
        const double length = map_.spacing() * std::hypot(step.x, step.y);
        std::vector<std::size_t> gap;
        std::size_t last = 0;  // place of the floor before the gap
        bool hasLast = false, isWhole = true;
        for (; map_.isIn(x, y); x += step.x, y += step.y) {
            const std::size_t here = map_.at(x, y);
            if (before[here] == 0) {
                gap.push_back(here);
                isWhole = isWhole && !std::isnan(map_.heightAt(here));
                continue;
            }
            const bool isNarrow = static_cast<double>(gap.size()) * length <= kRidgeWidth;
            if (hasLast && isWhole && isNarrow && isLow(gap, last, here)) {
                for (const std::size_t each : gap) floor_[each] = 1;
            }
            gap.clear();
            last = here;
            hasLast = isWhole = true;
        }
    }

    [[nodiscard]] bool isLow(const std::vector<std::size_t>& gap, std::size_t from, std::size_t to) const {
        const double a = map_.heightAt(from), b = map_.heightAt(to);
        if (std::abs(a - b) > kRidgeHeight) return false;
        return std::ranges::all_of(gap, [&](std::size_t each) {
            const double height = map_.heightAt(each);
            return height < std::max(a, b) + kRidgeHeight && height > std::min(a, b) - kRidgeHeight;
        });
    }

    const HeightMap& map_;
    Marks& floor_;
};

/// The largest connected part of `floor`, without what lies higher or lower by more than a ridge.
Marks largestPart(const HeightMap& map, const Marks& floor) {
    std::vector<std::uint32_t> part(map.size());  // 0: none yet
    std::vector<std::size_t> sizes = {0};
    std::vector<std::size_t> open;
    const auto visit = [&](std::size_t place) {
        part[place] = static_cast<std::uint32_t>(sizes.size() - 1);
        ++sizes.back();
        open.push_back(place);
    };
    for (std::size_t start = 0; start < map.size(); ++start) {
        if (floor[start] == 0 || part[start] != 0) continue;
        sizes.push_back(0);
        visit(start);
        while (!open.empty()) {
            const std::size_t here = open.back();
            open.pop_back();
            const int x = static_cast<int>(here % static_cast<std::size_t>(map.columns()));
            const int y = static_cast<int>(here / static_cast<std::size_t>(map.columns()));
            for (const Step& step : kNeighbours) {
                if (!map.isIn(x + step.x, y + step.y)) continue;
                const std::size_t next = map.at(x + step.x, y + step.y);
                if (floor[next] == 0 || part[next] != 0) continue;
                if (std::abs(map.heightAt(here) - map.heightAt(next)) < kRidgeHeight) visit(next);
            }
        }
    }
    const auto largest = static_cast<std::uint32_t>(std::ranges::max_element(sizes) - sizes.begin());
    Marks result(map.size());
    for (std::size_t i = 0; i < map.size(); ++i) result[i] = largest > 0 && part[i] == largest ? 1 : 0;
    return result;
}

/// Distance of each place of `part` from its border, mm; 0 elsewhere. What lies farther than twice the strip counts as
/// that far.
std::vector<double> distancesToBorder(const HeightMap& map, const Marks& part) {
    const int reach = static_cast<int>(std::ceil(2 * kRounding / map.spacing())) + 1;
    std::vector<double> distances(map.size());
    for (int y = 0; y < map.rows(); ++y) {
        for (int x = 0; x < map.columns(); ++x) {
            if (part[map.at(x, y)] == 0) continue;
            int nearest = reach * reach;
            for (int j = -reach; j <= reach; ++j) {
                for (int i = -reach; i <= reach; ++i) {
                    const int squared = i * i + j * j;
                    if (squared >= nearest) continue;
                    if (!map.isIn(x + i, y + j) || part[map.at(x + i, y + j)] == 0) nearest = squared;
                }
            }
            // The border runs between a place of the floor and one beside it.
            distances[map.at(x, y)] = (std::sqrt(nearest) - 0.5) * map.spacing();
        }
    }
    return distances;
}

std::vector<Vec3> floorWithin(const HeightMap& map, double slope) {
    Marks floor(map.size());
    for (std::size_t i = 0; i < map.size(); ++i)
        floor[i] = !std::isnan(map.heightAt(i)) && map.slopeAt(i) < slope ? 1 : 0;
    RidgeJoiner(map, floor).join();
    const Marks part = largestPart(map, floor);
    const auto count = static_cast<double>(std::ranges::count(part, 1));
    if (count * map.spacing() * map.spacing() < kLeastFloor) return {};
    const std::vector<double> distances = distancesToBorder(map, part);
    const double strip = std::min(kRounding, std::ranges::max(distances) / 2);
    std::vector<Vec3> places;
    for (int y = 0; y < map.rows(); ++y) {
        for (int x = 0; x < map.columns(); ++x) {
            if (distances[map.at(x, y)] >= strip) places.push_back(map.placeAt(x, y));
        }
    }
    return places;
}

}  // namespace

std::vector<Vec3> floorPlaces(const TriangleMesh& cut, const Vec3& axis) {
    const HeightMap map(cut, axis);
    if (map.size() == 0) return {};
    std::vector<Vec3> places = floorWithin(map, kFloorSlope);
    return places.empty() ? floorWithin(map, kSlopingFloor) : places;
}

}  // namespace tactooth
