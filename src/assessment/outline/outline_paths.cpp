// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/outline/outline_paths.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "assessment/outline/fissure_path.h"
#include "assessment/outline/flat_outline.h"
#include "session/control/surface_ray.h"

namespace tactooth {
namespace {

using Point = FlatOutline::Point;
using Line = std::vector<Point>;

constexpr double kStep = 0.1;       // mm between two places of a path
constexpr double kRow = 0.2;        // mm between two passes of a bur
constexpr double kLayer = 0.75;     // of a bur's head: how far apart two depths are
constexpr double kWallStep = 0.15;  // mm of depth between two passes along a wall that leans
constexpr double kGap = 2.5;        // times kStep: what is farther apart is no line
constexpr double kRounding = 1e-6;  // mm
constexpr double kArc = 0.2;        // rad between two places around a corner

/// Square to the edge from a to b, into an outline that runs counter-clockwise; unit.
Point inwardOf(const Point& a, const Point& b) {
    const Point along = (b - a).normalized();
    return {-along.y(), along.x()};
}

/// The places of a bur that rolls along the wall: the border of the outline, moved inwards. Corners run
/// counter-clockwise.
Line besideWall(const Line& corners, double inset) {
    Line line;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point &a = corners[i], &b = corners[(i + 1) % corners.size()], &c = corners[(i + 2) % corners.size()];
        const Point inward = inwardOf(a, b), after = inwardOf(b, c);
        const int steps = std::max(1, static_cast<int>(std::ceil((b - a).norm() / kStep)));
        for (int k = 0; k <= steps; ++k) line.emplace_back(a + (b - a) * k / steps + inset * inward);
        const double turn = std::atan2(inward.x() * after.y() - inward.y() * after.x(), inward.dot(after));
        if (turn > 0) {  // into the corner as far as it can go
            if (1 + inward.dot(after) > kRounding)
                line.emplace_back(b + inset / (1 + inward.dot(after)) * (inward + after));
            continue;
        }
        const int parts = static_cast<int>(std::ceil(-turn / kArc));
        for (int k = 1; k < parts; ++k) line.emplace_back(b + inset * (Eigen::Rotation2Dd(turn * k / parts) * inward));
    }
    return line;
}

/// An outline through which a bur goes.
class OutlinedCavity {
public:
    OutlinedCavity(const PreparationPlan& plan, const SurfacePart& outer)
        : plan_(plan),
          outline_(plan.outline->corners, plan.outward),
          surface_{.base = std::shared_ptr<const SurfacePart>(std::shared_ptr<void>(), &outer)},
          lean_(std::tan(plan.outline->taperDegrees * std::numbers::pi / 180)) {
        double sum = 0;
        int count = 0;
        for (const Line& row : rows(radius())) {
            for (const Point& point : row) {
                const auto height = heightAt(point);
                if (!height) continue;
                sum += *height;
                top_ = count == 0 ? *height : std::max(top_, *height);
                if (count++ == 0) inside_ = point;
            }
        }
        if (count > 0) mean_ = sum / count;
    }

    [[nodiscard]] std::optional<Vec3> reference() const {
        return mean_ ? std::optional(outline_.placeAt(inside_, *mean_)) : std::nullopt;
    }

    /// From the top down to the floor.
    [[nodiscard]] std::vector<BurPath> paths() {
        if (!mean_) return {};
        const double layer = kLayer * plan_.outline->burLength;
        const double highest = plan_.isFlat ? *mean_ - top_ : 0;
        std::vector<std::pair<double, bool>> levels = {{plan_.depth, true}};  // how deep; whether all or the wall alone
        for (double below = plan_.depth - layer; below > highest; below -= layer) levels.emplace_back(below, true);
        for (double below = plan_.depth - kWallStep; lean_ > 0 && below > 0; below -= kWallStep)
            levels.emplace_back(below, false);
        std::ranges::sort(levels);
        for (const auto& [below, isWhole] : levels) {
            // A bur leaves an upright step, whose middle lies on the wall.
            const double inset = radius() + lean_ * std::max(0.0, below - kWallStep / 2);
            if (isWhole) {
                for (const Line& row : rows(inset)) add(row, below, inset);
            }
            for (const Line& wall : walls(inset)) add(wall, below, inset);
        }
        return std::move(paths_);
    }

private:
    [[nodiscard]] double radius() const { return plan_.outline->burRadius; }

    [[nodiscard]] bool isFree(const Point& point, double inset) const {
        return outline_.contains(point) && outline_.distance(point) >= inset - kRounding;
    }

    [[nodiscard]] std::optional<double> heightAt(const Point& point) const {
        const auto hit = firstHit(surface_, {outline_.placeAt(point, kFarAway), -plan_.outward});
        return hit ? std::optional(kFarAway - *hit) : std::nullopt;
    }

    /// The places inside that are `inset` away from the border, row by row to and fro.
    [[nodiscard]] std::vector<Line> rows(double inset) const {
        std::vector<Line> rows;
        const Eigen::AlignedBox2d& box = outline_.box();
        bool isBack = false;
        for (double y = box.min().y() + kRow / 2; y < box.max().y(); y += kRow) {
            std::vector<Line> row;
            bool isOn = false;
            for (double x = box.min().x() + kStep / 2; x < box.max().x(); x += kStep) {
                const bool isInside = isFree(Point(x, y), inset);
                if (isInside && !isOn) row.emplace_back();
                if (isInside) row.back().emplace_back(x, y);
                isOn = isInside;
            }
            if (isBack) {
                std::ranges::reverse(row);
                for (Line& line : row) std::ranges::reverse(line);
            }
            if (!row.empty()) isBack = !isBack;
            std::ranges::move(row, std::back_inserter(rows));
        }
        return rows;
    }

    [[nodiscard]] std::vector<Line> walls(double inset) const {
        Line corners = outline_.corners();
        if (outline_.signedArea() < 0) std::ranges::reverse(corners);
        std::vector<Line> lines;
        for (const Point& point : besideWall(corners, inset)) {
            if (!isFree(point, inset)) continue;
            const bool goesOn = !lines.empty() && (lines.back().back() - point).norm() < kGap * kStep;
            if (!goesOn) lines.emplace_back();
            lines.back().push_back(point);
        }
        if (lines.empty() || (lines.back().back() - lines.front().front()).norm() > kGap * kStep) return lines;
        if (lines.size() == 1) {
            lines.front().push_back(lines.front().front());
        } else {  // one line runs over the first corner
            Line joined = std::move(lines.back());
            lines.pop_back();
            joined.insert(joined.end(), lines.front().begin(), lines.front().end());
            lines.front() = std::move(joined);
        }
        return lines;
    }

    /// Adds a path at one depth; what lies beside the tooth is left out where the floor follows its surface.
    void add(const Line& line, double below, double inset) {
        BurPath path;
        const auto end = [&] {
            if (!path.places.empty()) paths_.push_back(std::exchange(path, {}));
        };
        for (std::size_t i = 0; i < line.size(); ++i) {
            const auto height = plan_.isFlat ? mean_ : heightAt(line[i]);
            if (!height) {
                end();
                continue;
            }
            if (plan_.isFlat && i > 0 && i + 1 < line.size() && isStraight(line[i - 1], line[i], line[i + 1])) continue;
            if (path.places.empty()) path.lifts = paths_.empty() || !isOpen(end_, line[i], std::min(inset, endInset_));
            path.places.push_back(outline_.placeAt(line[i], *height - below));
            end_ = line[i];
            endInset_ = inset;
        }
        end();
    }

    static bool isStraight(const Point& a, const Point& b, const Point& c) {
        const Point before = (b - a).normalized(), after = (c - b).normalized();
        return before.dot(after) > 1 - kRounding * kRounding;
    }

    /// Whether the bur gets from one place to another without touching a wall.
    [[nodiscard]] bool isOpen(const Point& from, const Point& to, double inset) const {
        const int steps = std::max(1, static_cast<int>(std::ceil((to - from).norm() / kStep)));
        for (int i = 0; i <= steps; ++i) {
            if (!isFree(from + (to - from) * i / steps, inset - kStep * kStep)) return false;
        }
        return true;
    }

    const PreparationPlan& plan_;
    FlatOutline outline_;
    Surface surface_;
    double lean_;
    Point inside_ = Point::Zero();
    std::optional<double> mean_;  // height of the surface under the outline
    double top_ = 0;
    std::vector<BurPath> paths_;
    Point end_ = Point::Zero();  // of the last path
    double endInset_ = 0;
};

}  // namespace

std::optional<Vec3> outlineReference(const PreparationPlan& plan, const SurfacePart& outer) {
    return OutlinedCavity(plan, outer).reference();
}

std::optional<double> boxMiddle(const PreparationPlan& plan, const ProximalBox& box, double outside) {
    const FlatOutline outline(plan.outline->corners, plan.outward);
    const double wall = box.towardX * (outside - box.axialDepth);
    double low = 0, high = 0;
    bool isReached = false;
    double farthest = 0;
    for (const Vec3& corner : plan.outline->corners) farthest = std::max(farthest, std::abs(corner.y()));
    for (double y = -farthest; y <= farthest; y += kStep / 2) {
        if (!outline.contains(outline.flat(Vec3(wall, y, 0)))) continue;
        if (!isReached) low = y;
        high = y;
        isReached = true;
    }
    return isReached ? std::optional((low + high) / 2) : std::nullopt;
}

std::vector<BurPath> throughOutline(const PreparationPlan& plan, const std::shared_ptr<const SurfacePart>& outer) {
    OutlinedCavity cavity(plan, *outer);
    std::vector<BurPath> paths = cavity.paths();
    if (paths.empty() || plan.boxes.empty()) return paths;
    const CrownView crown(outer);
    const double height = cavity.reference()->z();
    for (const ProximalBox& box : plan.boxes) {
        const auto middle = boxMiddle(plan, box, crown.outside(box.towardX));
        if (!middle) return {};
        for (BurPath& path :
             throughBox(box, plan.outline->burRadius, plan.depth, crown, *middle, height - plan.depth)) {
            for (Vec3& place : path.places) place.z() = height - *path.depth;
            path.depth.reset();
            path.lifts = true;
            paths.push_back(std::move(path));
        }
    }
    return paths;
}

}  // namespace tactooth
