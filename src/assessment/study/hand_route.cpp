// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/study/hand_route.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "assessment/agreement/seeded_random.h"
#include "assessment/study/spread_task.h"
#include "geometry/util/assert.h"

namespace tactooth {
namespace {

constexpr double kLift = 2;      // mm above the highest place of the paths' surface
constexpr double kNextPath = 1;  // mm: to a path that begins so near, the bur goes without leaving the tooth
constexpr double kAbove = 0.2;   // mm above the surface, where a layer has nothing to cut
constexpr double kShortest = 1.5, kLongest = 5;  // mm: waves in which a hand strays, longer than those of its tremor
constexpr std::uint64_t kStraySeed = 0x5EED;     // other waves than those of the tremor

/// Adds stations; lifts the bur where the next run begins elsewhere.
class RouteBuilder {
public:
    RouteBuilder(const Vec3& outward, double clearHeight) : outward_(outward), clear_(clearHeight) {}

    void add(const std::vector<Vec3>& run) {
        if (run.empty()) return;
        const bool goesOn = !route_.empty() && (run.front() - route_.back().tip).norm() < kNextPath;
        if (!goesOn) {
            lift();
            route_.push_back({cleared(run.front())});
        }
        for (const Vec3& place : run) route_.push_back({place, true});
    }
    void lift() {
        if (!route_.empty()) route_.push_back({cleared(route_.back().tip)});
    }
    [[nodiscard]] std::vector<HandStation>& route() { return route_; }

private:
    [[nodiscard]] Vec3 cleared(const Vec3& place) const { return place + (clear_ - outward_.dot(place)) * outward_; }

    Vec3 outward_;
    double clear_;  // height along outward, mm
    std::vector<HandStation> route_;
};

/// One of the waves in which a hand strays.
struct StrayWave {
    Vec3 number;  // rad/mm
    double phase;
    [[nodiscard]] double at(const Vec3& place) const { return std::sin(number.dot(place) + phase); }
};

StrayWave randomWave(SeededRandom& random) {
    const double height = 2 * random.share() - 1, turn = 2 * std::numbers::pi * random.share();
    const double across = std::sqrt(1 - height * height);
    const double length = kShortest + (kLongest - kShortest) * random.share();
    const Vec3 direction(across * std::cos(turn), across * std::sin(turn), height);
    return {2 * std::numbers::pi / length * direction, 2 * std::numbers::pi * random.share()};
}

/// Leads the route beside itself, at the same place always likewise: a hand that misjudges a place does so in each
/// pass.
void stray(std::vector<HandStation>& route, double uneven, std::uint64_t seed) {
    if (uneven <= 0) return;
    std::array<std::array<StrayWave, 3>, 3> waves{};  // of each direction
    SeededRandom random(seed + kStraySeed);
    for (auto& direction : waves) std::ranges::generate(direction, [&] { return randomWave(random); });
    const double height = uneven * std::sqrt(2.0 / 3);  // each sine has the mean square 1/2
    for (HandStation& station : route) {
        if (!station.isInTooth) continue;
        const Vec3 meant = station.tip;
        for (std::size_t i = 0; i < waves.size(); ++i) {
            for (const StrayWave& wave : waves[i]) station.tip[static_cast<Eigen::Index>(i)] += height * wave.at(meant);
        }
    }
}

}  // namespace

std::vector<HandStation> routeOf(const HandTask& task, const HandHabits& habits, std::uint64_t seed) {
    TACTOOTH_ASSERT(!task.paths.empty() && task.paths.size() == task.depths.size());
    TACTOOTH_ASSERT(habits.layer > 0);
    const HandTask work = shortenedTask(spreadTask(task, habits.wider), task, habits.undone);
    double deepest = 0, highest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < work.paths.size(); ++i) {
        for (std::size_t k = 0; k < work.paths[i].size(); ++k) {
            deepest = std::max(deepest, work.depths[i][k] + habits.deeper);
            highest = std::max(highest, work.outward.dot(work.paths[i][k]) + std::max(work.depths[i][k], 0.0));
        }
    }
    RouteBuilder builder(work.outward, highest + kLift);
    const int layers = std::max(1, static_cast<int>(std::ceil(deepest / habits.layer)));
    for (int layer = layers - 1; layer >= 0; --layer) {
        const double raised = habits.layer * layer;
        for (std::size_t i = 0; i < work.paths.size(); ++i) {
            std::vector<Vec3> run;
            for (std::size_t k = 0; k < work.paths[i].size(); ++k) {
                const double depth = work.depths[i][k] + habits.deeper - raised;
                if (depth > -kAbove) {
                    run.push_back(work.paths[i][k] + (raised - habits.deeper) * work.outward);
                } else {
                    builder.add(run);
                    run.clear();
                }
            }
            builder.add(run);
        }
    }
    builder.lift();
    stray(builder.route(), habits.uneven, seed);
    return std::move(builder.route());
}

}  // namespace tactooth
