// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/study/spread_task.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <span>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

constexpr double kSame = 0.05;     // mm: nearer places are one
constexpr double kBeside = 0.6;    // mm: a path beside another one is not farther away
constexpr double kAbreast = 0.15;  // mm: more than half of the distance of two places of a path
constexpr double kSlack = 1e-9;    // mm: of rounding
constexpr int kAround = 8;         // directions around a lone place

/// The plane square to the shaft.
class ShaftPlane {
public:
    explicit ShaftPlane(const Vec3& outward) : u_(outward.unitOrthogonal()), v_(outward.cross(u_)) {}
    [[nodiscard]] Vec2 in(const Vec3& place) const { return {u_.dot(place), v_.dot(place)}; }
    [[nodiscard]] Vec3 out(const Vec2& shift) const { return shift.x() * u_ + shift.y() * v_; }

private:
    Vec3 u_, v_;
};

std::vector<Vec2> placesIn(const ShaftPlane& plane, const HandTask& task) {
    std::vector<Vec2> places;
    for (const auto& path : task.paths) {
        for (const Vec3& place : path) places.push_back(plane.in(place));
    }
    return places;
}

/// A part of a path that does not turn back, or a lone place.
struct Run {
    std::span<const Vec3> places;
    std::span<const double> depths;
};

class TaskSpreader {
public:
    TaskSpreader(const HandTask& task, double wider)
        : task_(task), plane_(task.outward), wider_(wider), all_(placesIn(plane_, task)) {}

    [[nodiscard]] HandTask spread() const {
        HandTask wide{{}, {}, task_.outward};
        for (std::size_t i = 0; i < task_.paths.size(); ++i) {
            wide.paths.emplace_back();
            wide.depths.emplace_back();
            for (const Run& run : runsOf(i)) add(run, wide);
        }
        return wide;
    }

private:
    [[nodiscard]] std::vector<Run> runsOf(std::size_t path) const {
        const std::span places(task_.paths[path]);
        const std::span depths(task_.depths[path]);
        std::vector<Run> runs;
        std::size_t begin = 0;
        for (std::size_t k = 1; k < places.size(); ++k) {
            const bool isLast = k + 1 == places.size();
            if (!isLast && plane_.in(places[k] - places[k - 1]).dot(plane_.in(places[k + 1] - places[k])) >= 0)
                continue;
            runs.push_back({places.subspan(begin, k + 1 - begin), depths.subspan(begin, k + 1 - begin)});
            begin = k;
        }
        if (runs.empty()) runs.push_back({places, depths});
        return runs;
    }

    /// Whether no other place of the work lies beside this one in that direction: there is the outline.
    [[nodiscard]] bool isOutline(const Vec2& place, const Vec2& direction) const {
        const Vec2 across(-direction.y(), direction.x());
        return std::ranges::none_of(all_, [&](const Vec2& other) {
            const double along = direction.dot(other - place);
            return along > kSame && along <= kBeside && std::abs(across.dot(other - place)) <= kAbreast;
        });
    }

    /// Where a place goes: on the path there, and on the path back beside one that stands alone.
    struct Shifts {
        Vec2 there, back;  // directions; zero: it stays
        bool standsAlone;
    };
    [[nodiscard]] Shifts shiftsAt(const Run& run, std::size_t k, const Vec2& along) const {
        const bool isFirst = k == 0, isLast = k + 1 == run.places.size();
        const Vec2 here = plane_.in(run.places[k]), aside(-along.y(), along.x());
        const bool left = isOutline(here, aside), right = isOutline(here, -aside);
        Vec2 end = Vec2::Zero();
        if (isFirst && isOutline(here, -along)) end = -along;
        if (isLast && isOutline(here, along)) end = along;
        if (left && right && end == Vec2::Zero()) return {aside, -aside, true};
        Vec2 shift = end;
        if (left && !right) shift += aside;
        if (right && !left) shift -= aside;
        return {shift, shift, left && right};
    }

    void add(const Run& run, HandTask& wide) const {
        const Vec2 length = plane_.in(run.places.back() - run.places.front());
        if (length.norm() < kSame) return addAround(run, wide);
        std::vector<Vec3> back;
        bool standsAlone = false;
        Vec2 along = length.normalized();
        for (std::size_t k = 0; k < run.places.size(); ++k) {
            const std::size_t before = k == 0 ? k : k - 1, after = std::min(k + 1, run.places.size() - 1);
            const Vec2 step = plane_.in(run.places[after] - run.places[before]);
            if (step.norm() > 0) along = step.normalized();  // else a step of height alone
            const Shifts shifts = shiftsAt(run, k, along);
            put(run.places[k], shifts.there, wide.paths.back());
            put(run.places[k], shifts.back, back);
            standsAlone = standsAlone || shifts.standsAlone;
        }
        std::ranges::copy(run.depths, std::back_inserter(wide.depths.back()));
        if (!standsAlone) return;
        std::ranges::reverse_copy(back, std::back_inserter(wide.paths.back()));
        std::ranges::reverse_copy(run.depths, std::back_inserter(wide.depths.back()));
    }

    void addAround(const Run& run, HandTask& wide) const {
        for (std::size_t k = 0; k < run.places.size(); ++k) {
            put(run.places[k], Vec2::Zero(), wide.paths.back());
            wide.depths.back().push_back(run.depths[k]);
            for (int i = 0; i < kAround; ++i) {
                const double angle = 2 * std::numbers::pi * i / kAround;
                const Vec2 direction(std::cos(angle), std::sin(angle));
                if (!isOutline(plane_.in(run.places[k]), direction)) continue;
                put(run.places[k], direction, wide.paths.back());
                wide.depths.back().push_back(run.depths[k]);
            }
        }
    }

    void put(const Vec3& place, const Vec2& direction, std::vector<Vec3>& path) const {
        const double length = direction.norm();
        path.push_back(length > 0 ? Vec3(place + wider_ * plane_.out(direction / length)) : place);
    }

    const HandTask& task_;
    ShaftPlane plane_;
    double wider_;
    std::vector<Vec2> all_;
};

/// Of the places, unit.
Vec2 longestDirection(const std::vector<Vec2>& places) {
    Vec2 mean = Vec2::Zero();
    for (const Vec2& place : places) mean += place / static_cast<double>(places.size());
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (const Vec2& place : places) spread += (place - mean) * (place - mean).transpose();
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvectors().col(1);
}

}  // namespace

HandTask spreadTask(const HandTask& task, double wider) {
    TACTOOTH_ASSERT(wider >= 0);
    return wider > 0 ? TaskSpreader(task, wider).spread() : task;
}

HandTask shortenedTask(const HandTask& task, const HandTask& whole, double share) {
    TACTOOTH_ASSERT(!whole.paths.empty() && share >= 0 && share <= 1);
    if (share == 0) return task;
    const ShaftPlane plane(whole.outward);
    const std::vector<Vec2> places = placesIn(plane, whole);
    Vec2 along = longestDirection(places);
    const auto [near, far] = std::ranges::minmax(places, {}, [&](const Vec2& place) { return along.dot(place); });
    const double middle = along.dot(near + far) / 2, length = along.dot(far - near);
    double limit = along.dot(far) - share * length + kSlack;
    if (along.dot(places.back()) < middle) along = -along, limit = along.dot(near) - share * length + kSlack;
    HandTask left{{}, {}, task.outward};
    for (std::size_t i = 0; i < task.paths.size(); ++i) {
        bool goesOn = false;
        for (std::size_t k = 0; k < task.paths[i].size(); ++k) {
            const double raised = length < kSame ? share * task.depths[i][k] : 0;
            const bool isLeft = length >= kSame && along.dot(plane.in(task.paths[i][k])) > limit;
            if (!isLeft && !goesOn) left.paths.emplace_back(), left.depths.emplace_back();
            goesOn = !isLeft;
            if (isLeft) continue;
            left.paths.back().push_back(task.paths[i][k] + raised * task.outward);
            left.depths.back().push_back(task.depths[i][k] - raised);
        }
    }
    return left;
}

}  // namespace tactooth
