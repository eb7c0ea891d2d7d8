// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/outline/fissure_path.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tactooth {
namespace {

constexpr double kStation = 0.2;       // mm along the fissure
constexpr double kAside = 0.1;         // mm across it
constexpr double kBetweenCusps = 0.2;  // of the crown's width, to both sides of its middle: there the fissure runs
constexpr double kBend = 0.4;          // mm of height that a step of 1 mm aside must save: a path without jumps
constexpr int kSmoothings = 6;         // of the path, each over three stations
constexpr double kTurn = 2.5;          // mm before a box, in which the cavity turns toward it
constexpr double kLevel = 0.8;         // mm between two depths of a box: less than a bur's head is long
constexpr double kRow = 0.2;           // mm between two passes of a bur

/// The bottom of the valley between the cusps, from one x to another: the path of least height that bends little, by
/// dynamic programming (R. Bellman, "Dynamic Programming", 1957), then smoothed.
std::vector<Vec3> fissurePath(const CrownView& crown, double fromX, double toX) {
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
double turnToBox(std::vector<Vec3>& path, const ProximalBox& box, const CrownView& crown) {
    const Vec3 end = box.towardX > 0 ? path.back() : path.front();
    const double shift = (crown.contact(box.towardX).y() - end.y()) / 2;
    for (Vec3& place : path) {
        const double t = std::clamp(1 - std::abs(place.x() - end.x()) / kTurn, 0.0, 1.0);
        place.y() += shift * t * t * (3 - 2 * t);
    }
    return end.y() + shift;
}

}  // namespace

FissureMiddle fissureMiddle(const PreparationPlan& plan, const CrownView& crown) {
    const FissureOutline& outline = *plan.fissure;
    const auto endToward = [&](double towardX, const std::optional<double>& left) {
        if (left) return crown.outside(towardX) - *left - outline.burRadius;
        const auto box = std::ranges::find(plan.boxes, towardX, &ProximalBox::towardX);
        return crown.outside(towardX) - box->axialDepth;
    };
    const double from = -endToward(-1, outline.leftMinusX), to = endToward(1, outline.leftPlusX);
    FissureMiddle middle;
    if (to - from < kStation) return middle;
    middle.path = fissurePath(crown, from, to);
    for (const ProximalBox& box : plan.boxes) middle.boxesAt.push_back(turnToBox(middle.path, box, crown));
    return middle;
}

std::vector<BurPath> throughBox(const ProximalBox& box, double burRadius, double depth, const CrownView& crown,
                                double middle, double floor) {
    std::vector<BurPath> paths;
    const double wall = crown.outsideAt(box.towardX, middle, floor - box.axialHeight) - box.axialDepth;
    const double side = box.width / 2 - burRadius;
    const int levels = std::max(1, static_cast<int>(std::ceil(box.axialHeight / kLevel)));
    const double first = wall + burRadius, last = std::max(first, crown.outside(box.towardX));
    const int rows = std::max(1, static_cast<int>(std::ceil((last - first) / kRow)));
    for (int level = 0; level <= levels; ++level) {
        BurPath pass{{}, depth + box.axialHeight * level / levels};
        pass.places.emplace_back(box.towardX * first, middle, 0);  // in the occlusal part
        for (int row = 0; row <= rows; ++row) {
            const double x = box.towardX * (first + (last - first) * row / rows);
            const double sign = row % 2 == 0 ? 1 : -1;
            pass.places.emplace_back(x, middle - sign * side, 0);
            pass.places.emplace_back(x, middle + sign * side, 0);
        }
        paths.push_back(std::move(pass));
    }
    return paths;
}

}  // namespace tactooth
