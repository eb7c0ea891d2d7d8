// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <limits>
#include <vector>

#include "assessment/study/hand_route.h"
#include "geometry/util/pose.h"

namespace tactooth {

/// What a hand senses: the force, and where the bur is.
struct HandSense {
    double force = 0;  ///< N
    Vec3 bur;          ///< place of its tip as the tooth lets it be, tooth frame, mm
};

/// A hand that leads a bur along a route. It sees how far the bur stays behind, aims as far beyond, waits until the bur
/// is where it should be, and holds back when the force is too large. It senses with a delay, but knows its own
/// movement, and has a tremor. The same seed gives the same movement, bit for bit.
class SyntheticHand {
public:
    /// `route`: not empty, as `routeOf` gives it.
    SyntheticHand(std::vector<HandStation> route, const Vec3& outward, const HandHabits& habits, std::uint64_t seed);

    /// The pose of the tool that the hand wants, `elapsed` s after the last one.
    [[nodiscard]] Pose move(double elapsed, const HandSense& now);
    /// Where the hand wants the tip of the bur, without its tremor, tooth frame, mm.
    [[nodiscard]] const Vec3& place() const { return at_; }
    /// Whether it is at the end of its route.
    [[nodiscard]] bool isDone() const { return next_ >= route_.size(); }

private:
    struct Wave {
        double frequency;          // rad/s
        std::array<double, 3> at;  // phase, rad
    };
    struct Sensed {
        double time, force;
        Vec3 lag;  // from the hand to the bur, mm
    };
    void sense(const HandSense& now);
    [[nodiscard]] bool hasReached(const HandStation& goal) const;
    [[nodiscard]] double distanceTo(const HandStation& goal) const;
    [[nodiscard]] double acceptedForce() const;
    void wait(const HandStation& goal, double elapsed);
    void press(const HandStation& goal, double elapsed);
    [[nodiscard]] Vec3 trembling() const;

    std::vector<HandStation> route_;
    std::vector<std::size_t> turns_;  // of each station: that at which the hand next turns or stops
    HandHabits habits_;
    Quat grip_;
    std::size_t next_ = 1;
    Vec3 at_;
    double time_ = 0;                                           // s
    double waited_ = 0;                                         // s at the present station without coming nearer
    double nearest_ = std::numeric_limits<double>::infinity();  // mm: that the bur has been to it
    Sensed known_{0, 0, Vec3::Zero()};                          // what has reached the hand by now
    std::deque<Sensed> coming_;
    std::array<Wave, 4> waves_;
};

}  // namespace tactooth
