// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "assessment/study/hand_habits.h"
#include "geometry/util/pose.h"

namespace tactooth {

/// One place of the route of a hand.
struct HandStation {
    Vec3 tip;                ///< of the bur, tooth frame, mm
    bool isInTooth = false;  ///< the way to it goes through the tooth; false: the hand lifts the bur, or travels
};

/// What a hand works on.
struct HandTask {
    std::vector<std::vector<Vec3>> paths;     ///< of the bur's tip through the ideal preparation, tooth frame, mm
    std::vector<std::vector<double>> depths;  ///< of each place below the uncut surface along the shaft, mm
    Vec3 outward = Vec3::UnitZ();             ///< direction of the shaft, unit
};

/// The way of a bur through a preparation in layers, from above; between two paths it is lifted. The habits `layer`,
/// `deeper`, `wider` and `undone` shape it.
[[nodiscard]] std::vector<HandStation> routeOf(const HandTask& task, const HandHabits& habits);

/// A hand that follows a route, trembles, feels the force late, and holds back when it presses too hard. The same seed
/// gives the same movement, bit for bit.
class SyntheticHand {
public:
    /// `route`: not empty, as `routeOf` gives it.
    SyntheticHand(std::vector<HandStation> route, const Vec3& outward, const HandHabits& habits, std::uint64_t seed);

    /// The pose of the tool, `elapsed` s after the last one. `force`: that the hand feels now, N.
    [[nodiscard]] Pose move(double elapsed, double force);
    /// Whether it is at the end of its route.
    [[nodiscard]] bool isDone() const { return next_ >= route_.size(); }

private:
    struct Wave {
        double frequency;          // rad/s
        std::array<double, 3> at;  // phase, rad
    };
    struct Feeling {
        double time, force;
    };
    [[nodiscard]] double feltForce(double force);
    [[nodiscard]] Vec3 trembling() const;

    std::vector<HandStation> route_;
    HandHabits habits_;
    Quat grip_;
    std::size_t next_ = 1;
    Vec3 at_;
    double time_ = 0;  // s
    double felt_ = 0;  // N
    std::deque<Feeling> feelings_;
    std::array<Wave, 4> waves_;
};

}  // namespace tactooth
