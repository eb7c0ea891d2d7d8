// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/base/rate_controller.h"

#include <algorithm>
#include <cmath>

namespace tactooth {
namespace {

constexpr double kSmoothing = 40;  // 1/s: readings arrive 100 to 250 times a second, the pose moves 1000 times
// Admittance, mm/s for each newton: a stick command of 20 mm/s presses with 2.5 N. On enamel (1 N/mm) the force follows
// the stick within an eighth of a second. The value is far below the one that would oscillate on the stiffest wall.
constexpr double kYield = 8;
constexpr double kMaxLean = 1.2;        // rad from the start orientation: a handpiece is not held upside down
constexpr double kLongestStep = 0.1;    // s: after a stall the pose continues gently
constexpr double kStrongestForce = 20;  // N: no device renders more, so a larger value is not plausible

}  // namespace

Pose RateController::advance(const RateCommand& asked, double elapsed) {
    const double dt = std::isfinite(elapsed) ? std::clamp(elapsed, 0.0, kLongestStep) : 0;
    // A NaN would stay in the smoothed rate for ever.
    const RateCommand wanted = asked.speed.allFinite() && asked.turn.allFinite() ? asked : RateCommand{};
    const double part = 1 - std::exp(-kSmoothing * dt);
    rate_.speed += part * (wanted.speed - rate_.speed);
    rate_.turn += part * (wanted.turn - rate_.turn);
    const Vec3 force = force_.cwiseMax(-kStrongestForce).cwiseMin(kStrongestForce);
    hand_.position += dt * (rate_.speed + kYield * force);
    hand_.position = hand_.position.cwiseMax(-kReach).cwiseMin(kReach);
    const double angle = dt * rate_.turn.norm();
    if (angle > 0) {
        const Quat turned = Quat(Eigen::AngleAxisd(angle, rate_.turn.normalized())) * hand_.rotation;
        if ((turned * Vec3::UnitZ()).z() >= std::cos(kMaxLean)) hand_.rotation = turned.normalized();
    }
    return hand_;
}

}  // namespace tactooth
