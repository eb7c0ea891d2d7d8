// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "assessment/body_paths.h"
#include "assessment/exercise.h"
#include "session/control/surface_ray.h"

namespace tactooth {
namespace {

constexpr double kPathStep = 0.1;      // mm between two places: a floor that follows the surface is as fine
constexpr double kStation = 0.2;       // mm along the fissure
constexpr double kAside = 0.1;         // mm across it
constexpr double kBetweenCusps = 0.2;  // of the crown's width, to both sides of its middle: there the fissure runs
constexpr double kBend = 0.4;          // mm of height that a step of 1 mm aside must save: a path without jumps
constexpr int kSmoothings = 6;         // of the path, each over three stations
constexpr double kTurn = 2.5;          // mm before a box, in which the cavity turns toward it
constexpr double kContact = 0.15;      // mm: what is so near to the farthest point is the contact area
constexpr double kLevel = 0.8;         // mm between two depths of a box: less than a bur's head is long
constexpr double kRow = 0.2;           // mm between two passes of a bur
constexpr double kFarAway = 60;        // mm

std::vector<Vec3> placesOf(const Vec3& from, const Vec3& to) {
    const int steps = static_cast<int>(std::ceil((to - from).norm() / kPathStep));
    std::vector<Vec3> places = {from};
    for (int i = 1; i <= steps; ++i) places.push_back(from + (to - from) * i / steps);
    return places;
}

/// A crown seen from above.
class Crown {
public:
    explicit Crown(std::shared_ptr<const SurfacePart> outer) : surface_{.base = std::move(outer)} {
        for (const Vec3f& vertex : vertices()) {
            if (vertex.z() > 0) box_.extend(vertex.cast<double>());
        }
    }

    [[nodiscard]] const Box3& box() const { return box_; }

    /// Height of the crown at a place; lowest of all where there is none.
    [[nodiscard]] double heightAt(double x, double y) const {
        const auto hit = firstHit(surface_, {Vec3(x, y, kFarAway), -Vec3::UnitZ()});
        return hit ? kFarAway - *hit : -kFarAway;
    }

    /// Middle of the contact area on a proximal side.
    [[nodiscard]] Vec3 contact(double towardX) const {
        Vec3 sum = Vec3::Zero();
        int count = 0;
        const double farthest = outside(towardX);
        for (const Vec3f& vertex : vertices()) {
            if (vertex.z() <= 0 || towardX * vertex.x() < farthest - kContact) continue;
            sum += vertex.cast<double>();
            ++count;
        }
        return sum / count;
    }

    /// Distance of the outermost point of a proximal side from the tooth's axis, mm.
    [[nodiscard]] double outside(double towardX) const { return towardX > 0 ? box_.max().x() : -box_.min().x(); }

    /// The same in one direction at one height.
    [[nodiscard]] double outsideAt(double towardX, double y, double z) const {
        const auto hit = firstHit(surface_, {Vec3(towardX * kFarAway, y, z), -towardX * Vec3::UnitX()});
        return hit ? kFarAway - *hit : outside(towardX);
    }

private:
    [[nodiscard]] const std::vector<Vec3f>& vertices() const { return surface_.base->mesh().vertices; }

    Surface surface_;
    Box3 box_;
};

/// The bottom of the valley between the cusps, from one x to another: the path of least height that bends little, by
/// dynamic programming (R. Bellman, "Dynamic Programming", 1957), then smoothed.
std::vector<Vec3> fissurePath(const Crown& crown, double fromX, double toX) {
    const int stations = std::max(2, static_cast<int>(std::ceil((toX - fromX) / kStation)) + 1);
    const double middle = crown.box().center().y();
    const int half = static_cast<int>(kBetweenCusps * crown.box().sizes().y() / kAside);
    const auto yOf = [&](int j) { return middle + kAside * (j - half); };
    const auto xOf = [&](int i) { return fromX + (toX - fromX) * i / (stations - 1); };
    const auto count = static_cast<std::size_t>(2 * half + 1);
    std::vector<std::vector<double>> cost(static_cast<std::size_t>(stations), std::vector<double>(count));
    std::vector<std::vector<int>> before(static_cast<std::size_t>(stations), std::vector<int>(count, 0));
    for (int i = 0; i < stations; ++i) {
        const auto station = static_cast<std::size_t>(i);
        for (int j = 0; j <= 2 * half; ++j) {
            double least = i == 0 ? 0 : std::numeric_limits<double>::infinity();
            for (int k = 0; i > 0 && k <= 2 * half; ++k) {
                const double sum = cost[station - 1][static_cast<std::size_t>(k)] + kBend * kAside * std::abs(j - k);
                if (sum >= least) continue;
                least = sum;
                before[station][static_cast<std::size_t>(j)] = k;
            }
            cost[station][static_cast<std::size_t>(j)] = least + crown.heightAt(xOf(i), yOf(j));
        }
    }
    int j = static_cast<int>(std::ranges::min_element(cost.back()) - cost.back().begin());
    std::vector<Vec3> path(static_cast<std::size_t>(stations));
    for (int i = stations - 1; i >= 0; --i) {
        path[static_cast<std::size_t>(i)] = Vec3(xOf(i), yOf(j), 0);
        j = before[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
    }
    for (int pass = 0; pass < kSmoothings; ++pass) {
        const std::vector<Vec3> rough = path;
        for (std::size_t i = 0; i < path.size(); ++i) {
            const double last = rough[i > 0 ? i - 1 : 0].y(), next = rough[std::min(i + 1, path.size() - 1)].y();
            path[i].y() = (last + rough[i].y() + next) / 3;
        }
    }
    return path;
}

/// Turns the end of the path toward a box, halfway to the contact; the contact seldom lies where the fissure ends.
/// Returns the middle of the box (y).
double turnToBox(std::vector<Vec3>& path, const ProximalBox& box, const Crown& crown) {
    const Vec3 end = box.towardX > 0 ? path.back() : path.front();
    const double shift = (crown.contact(box.towardX).y() - end.y()) / 2;
    for (Vec3& place : path) {
        const double t = std::clamp(1 - std::abs(place.x() - end.x()) / kTurn, 0.0, 1.0);
        place.y() += shift * t * t * (3 - 2 * t);
    }
    return end.y() + shift;
}

/// The passes of a box, from the pulpal floor down; `middle`: y of the box; `floor`: height of the pulpal floor.
void addBox(std::vector<BurPath>& paths, const PreparationPlan& plan, const ProximalBox& box, const Crown& crown,
            double middle, double floor) {
    const double radius = plan.fissure->burRadius;
    const double wall = crown.outsideAt(box.towardX, middle, floor - box.axialHeight) - box.axialDepth;
    const double side = box.width / 2 - radius;
    const int levels = std::max(1, static_cast<int>(std::ceil(box.axialHeight / kLevel)));
    const double first = wall + radius, last = std::max(first, crown.outside(box.towardX));
    const int rows = std::max(1, static_cast<int>(std::ceil((last - first) / kRow)));
    for (int level = 0; level <= levels; ++level) {
        BurPath pass{{}, plan.depth + box.axialHeight * level / levels};
        pass.places.emplace_back(box.towardX * first, middle, 0);  // in the occlusal part
        for (int row = 0; row <= rows; ++row) {
            const double x = box.towardX * (first + (last - first) * row / rows);
            const double sign = row % 2 == 0 ? 1 : -1;
            pass.places.emplace_back(x, middle - sign * side, 0);
            pass.places.emplace_back(x, middle + sign * side, 0);
        }
        paths.push_back(std::move(pass));
    }
}

std::vector<BurPath> alongFissure(const PreparationPlan& plan, std::shared_ptr<const SurfacePart> outer) {
    const Crown crown(std::move(outer));
    const FissureOutline& outline = *plan.fissure;
    const auto endToward = [&](double towardX, const std::optional<double>& left) {
        if (left) return crown.outside(towardX) - *left - outline.burRadius;
        const auto box = std::ranges::find(plan.boxes, towardX, &ProximalBox::towardX);
        return crown.outside(towardX) - box->axialDepth;
    };
    const double from = -endToward(-1, outline.leftMinusX), to = endToward(1, outline.leftPlusX);
    if (to - from < kStation) return {};
    std::vector<Vec3> middle = fissurePath(crown, from, to);
    std::vector<double> boxesAt;
    for (const ProximalBox& box : plan.boxes) boxesAt.push_back(turnToBox(middle, box, crown));
    // The bur enters in the middle, where the passes beside take away the wider hole of its way in.
    BurPath along{{middle.begin() + static_cast<std::ptrdiff_t>(middle.size() / 2), middle.end()}, plan.depth};
    along.places.insert(along.places.end(), middle.rbegin(), middle.rend());
    std::vector<BurPath> paths = {along};
    const double aside = outline.width / 2 - outline.burRadius;
    const int rows = static_cast<int>(std::ceil(aside / kRow));
    for (int row = 1; row <= rows; ++row) {
        for (const double sign : {1.0, -1.0}) {
            BurPath path{middle, plan.depth};
            for (Vec3& place : path.places) place.y() += sign * aside * row / rows;
            if (sign < 0) std::ranges::reverse(path.places);
            paths.push_back(std::move(path));
        }
    }
    double sum = 0;
    for (const Vec3& place : middle) sum += crown.heightAt(place.x(), place.y());
    const double floor = sum / static_cast<double>(middle.size()) - plan.depth;
    for (std::size_t i = 0; i < plan.boxes.size(); ++i) addBox(paths, plan, plan.boxes[i], crown, boxesAt[i], floor);
    return paths;
}

}  // namespace

std::vector<BurPath> burPaths(const PreparationPlan& plan, const LayeredTooth& tooth,
                              const std::shared_ptr<const SurfacePart>& outer) {
    if (plan.fissure) return alongFissure(plan, outer);
    if (plan.body) return throughBody(plan, tooth, *outer);
    std::vector<BurPath> paths;
    for (const PreparationPlan::Stroke& stroke : plan.strokes)
        paths.push_back({placesOf(stroke.from, stroke.to), stroke.depth.value_or(plan.depth)});
    return paths;
}

}  // namespace tactooth
