// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/study/synthetic_hand.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "assessment/agreement/seeded_random.h"
#include "geometry/util/assert.h"

namespace tactooth {
namespace {

constexpr double kCutting = 3;     // mm/s in the tooth
constexpr double kUsualForce = 2;  // N: a hand that accepts more goes on faster, or it would not press harder
constexpr double kTravel = 20;     // mm/s above it
constexpr double kLift = 2;        // mm above the highest place of the paths' surface
constexpr double kNextPath = 1;    // mm: to a path that begins so near, the bur goes without leaving the tooth
constexpr double kReached = 0.05;  // mm from the bur to a station: as near as the eye can tell
constexpr double kPatience = 0.8;  // s without progress until the hand gives a station up, at a wall that holds the bur
constexpr double kProgress = 0.02;            // mm nearer to the station: as little as the eye can tell in that time
constexpr double kMostLead = 1;               // mm beyond a station
constexpr double kAbove = 0.2;                // mm above the surface, where a layer has nothing to cut
constexpr double kLowest = 8, kHighest = 12;  // Hz, of physiological tremor

/// Mean of all places without their height.
Vec3 middleOf(const HandTask& task) {
    Vec3 sum = Vec3::Zero();
    double count = 0;
    for (const auto& path : task.paths) {
        for (const Vec3& place : path) sum += place;
        count += static_cast<double>(path.size());
    }
    return sum / count;
}

double lengthOf(std::span<const HandStation> route) {
    double length = 0;
    for (std::size_t i = 1; i < route.size(); ++i) {
        if (route[i].isInTooth) length += (route[i].tip - route[i - 1].tip).norm();
    }
    return length;
}

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

/// Ends the route before the last `share` of its length in the tooth.
void cutShort(std::vector<HandStation>& route, double share) {
    double left = lengthOf(route) * (1 - share);
    for (std::size_t i = 1; i < route.size(); ++i) {
        if (!route[i].isInTooth) continue;
        const Vec3 displacement = route[i].tip - route[i - 1].tip;
        const double length = displacement.norm();
        left -= length;
        if (left >= 0) continue;
        route[i].tip += left / length * displacement;
        route.resize(i + 1);
        return;
    }
}

}  // namespace

std::vector<HandStation> routeOf(const HandTask& task, const HandHabits& habits) {
    TACTOOTH_ASSERT(!task.paths.empty() && task.paths.size() == task.depths.size());
    TACTOOTH_ASSERT(habits.layer > 0);
    double deepest = 0, highest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < task.paths.size(); ++i) {
        for (std::size_t k = 0; k < task.paths[i].size(); ++k) {
            deepest = std::max(deepest, task.depths[i][k] + habits.deeper);
            highest = std::max(highest, task.outward.dot(task.paths[i][k]) + std::max(task.depths[i][k], 0.0));
        }
    }
    const Vec3 middle = middleOf(task);
    const auto shifted = [&](const Vec3& place) {
        Vec3 aside = place - middle;
        aside -= aside.dot(task.outward) * task.outward;
        const double distance = aside.norm();
        if (distance > 0) aside *= habits.wider / distance;
        return Vec3(place + aside - habits.deeper * task.outward);
    };
    RouteBuilder builder(task.outward, highest + kLift);
    const int layers = std::max(1, static_cast<int>(std::ceil(deepest / habits.layer)));
    for (int layer = layers - 1; layer >= 0; --layer) {
        const double raised = habits.layer * layer;
        for (std::size_t i = 0; i < task.paths.size(); ++i) {
            std::vector<Vec3> run;
            for (std::size_t k = 0; k < task.paths[i].size(); ++k) {
                const double depth = task.depths[i][k] + habits.deeper - raised;
                if (depth > -kAbove) {
                    run.push_back(shifted(task.paths[i][k]) + raised * task.outward);
                } else {
                    builder.add(run);
                    run.clear();
                }
            }
            builder.add(run);
        }
    }
    std::vector<HandStation> route = std::move(builder.route());
    cutShort(route, habits.undone);
    RouteBuilder end(task.outward, highest + kLift);
    end.route() = std::move(route);
    end.lift();
    return std::move(end.route());
}

SyntheticHand::SyntheticHand(std::vector<HandStation> route, const Vec3& outward, const HandHabits& habits,
                             std::uint64_t seed)
    : route_(std::move(route)), habits_(habits), grip_(shortestRotation(Vec3::UnitZ(), outward)) {
    TACTOOTH_ASSERT(!route_.empty() && habits.force > 0 && habits.delay >= 0);
    at_ = route_.front().tip;
    SeededRandom random(seed);
    for (Wave& wave : waves_) {
        wave.frequency = 2 * std::numbers::pi * (kLowest + (kHighest - kLowest) * random.share());
        for (double& phase : wave.at) phase = 2 * std::numbers::pi * random.share();
    }
}

void SyntheticHand::sense(const HandSense& now) {
    coming_.push_back({time_, now.force, now.bur - at_});
    while (!coming_.empty() && coming_.front().time <= time_ - habits_.delay) {
        known_ = coming_.front();
        coming_.pop_front();
    }
}

Vec3 SyntheticHand::trembling() const {
    // Each sine has the mean square 1/2.
    const double height = habits_.tremor * std::sqrt(2.0 / static_cast<double>(waves_.size()));
    Vec3 shift = Vec3::Zero();
    for (const Wave& wave : waves_) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            shift[static_cast<Eigen::Index>(axis)] += height * std::sin(wave.frequency * time_ + wave.at[axis]);
    }
    return shift;
}

/// Above the tooth it is enough that the hand is there.
bool SyntheticHand::hasReached(const HandStation& goal) const {
    if (!goal.isInTooth) return at_ == goal.tip;
    return distanceTo(goal) < kReached || waited_ > kPatience;
}

/// From the bur as the hand sees it, mm.
double SyntheticHand::distanceTo(const HandStation& goal) const { return (at_ + known_.lag - goal.tip).norm(); }

/// Hard tooth takes its time: as long as the bur comes nearer, the hand does not give up.
void SyntheticHand::wait(const HandStation& goal, double elapsed) {
    waited_ += elapsed;
    const double distance = distanceTo(goal);
    if (distance > nearest_ - kProgress) return;
    nearest_ = distance;
    waited_ = 0;
}

/// Moves on toward a station. In the tooth the hand aims beyond it, as far as the bur is still short of it.
void SyntheticHand::press(const HandStation& goal, double elapsed) {
    Vec3 aim = goal.tip;
    double speed = kTravel;
    if (goal.isInTooth) {
        // Full speed up to half of the force that the hand accepts, none at it, and back beyond it.
        const double eagerness = std::clamp(2 * (1 - known_.force / habits_.force), -1.0, 1.0);
        const double lag = known_.lag.norm();
        if (eagerness > 0) aim -= known_.lag * (lag > kMostLead ? kMostLead / lag : 1);
        if (eagerness < 0) aim = at_ + known_.lag;
        speed = kCutting * std::max(1.0, habits_.force / kUsualForce) * std::abs(eagerness);
    }
    const Vec3 displacement = aim - at_;
    const double needed = displacement.norm();
    at_ = needed <= speed * elapsed ? aim : Vec3(at_ + displacement * (speed * elapsed / needed));
}

Pose SyntheticHand::move(double elapsed, const HandSense& now) {
    time_ += elapsed;
    sense(now);
    while (!isDone() && hasReached(route_[next_])) {
        ++next_;
        waited_ = 0;
        nearest_ = std::numeric_limits<double>::infinity();
    }
    if (!isDone()) {
        wait(route_[next_], elapsed);
        press(route_[next_], elapsed);
    }
    return {at_ + trembling(), grip_};
}

}  // namespace tactooth
