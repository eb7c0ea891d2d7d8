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
constexpr double kReached = 0.05;  // mm from the bur to a station: as near as the eye can tell
constexpr double kPatience = 0.8;  // s without progress until the hand gives a station up, at a wall that holds the bur
constexpr double kProgress = 0.02;            // mm nearer to the station: as little as the eye can tell in that time
constexpr double kMostLead = 1;               // mm beyond a station
constexpr double kEasing = 0.5;               // mm before a place where it turns or stops: from there it presses less
constexpr double kEased = 0.3;                // share of its force that is left there
constexpr double kLowest = 8, kHighest = 12;  // Hz, of physiological tremor

/// Whether a hand turns or stops at a station: it does not go on within 60 degrees.
bool turnsAt(const std::vector<HandStation>& route, std::size_t index) {
    if (index == 0 || index + 1 >= route.size() || !route[index + 1].isInTooth) return true;
    const Vec3 before = route[index].tip - route[index - 1].tip, after = route[index + 1].tip - route[index].tip;
    return before.dot(after) < 0.5 * before.norm() * after.norm();
}

}  // namespace

SyntheticHand::SyntheticHand(std::vector<HandStation> route, const Vec3& outward, const HandHabits& habits,
                             std::uint64_t seed)
    : route_(std::move(route)), habits_(habits), grip_(shortestRotation(Vec3::UnitZ(), outward)) {
    TACTOOTH_ASSERT(!route_.empty() && habits.force > 0 && habits.delay >= 0);
    at_ = route_.front().tip;
    turns_.resize(route_.size());
    for (std::size_t i = route_.size(); i-- > 0;) turns_[i] = turnsAt(route_, i) ? i : turns_[i + 1];
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

/// The force that the hand accepts, N. A hand that presses as hard as before until it turns goes too far: the spring of
/// the contact leads the bur on.
double SyntheticHand::acceptedForce() const {
    return habits_.force * std::clamp(distanceTo(route_[turns_[next_]]) / kEasing, kEased, 1.0);
}

/// Moves on toward a station. In the tooth the hand aims beyond it, as far as the bur is still short of it.
void SyntheticHand::press(const HandStation& goal, double elapsed) {
    Vec3 aim = goal.tip;
    double speed = kTravel;
    if (goal.isInTooth) {
        // Full speed up to half of the force that the hand accepts, none at it, and back beyond it.
        const double eagerness = std::clamp(2 * (1 - known_.force / acceptedForce()), -1.0, 1.0);
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
