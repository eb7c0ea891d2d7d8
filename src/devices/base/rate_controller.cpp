// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/base/rate_controller.h"

#include <algorithm>
#include <cmath>

namespace tactooth {
namespace {

constexpr double kSmoothing = 40;  // 1/s: readings come 100 to 250 times a second, the hand moves 1000 times
// mm/s that the hand gives way to each newton: 20 mm/s of a stick press 2.5 N. On enamel (1 N/mm) force follows the
// stick within an eighth of a second; far below what would shake on the stiffest wall.
constexpr double kYield = 8;
constexpr double kMaxLean = 1.2;        // rad from where it began: a handpiece does not stand on its head
constexpr double kLongestStep = 0.1;    // s: after a stall the hand goes on gently
constexpr double kStrongestForce = 20;  // N: no device renders more, so a stronger one is no measure

}  // namespace

Pose RateController::advance(const RateCommand& asked, double elapsed) {
    const double dt = std::isfinite(elapsed) ? std::clamp(elapsed, 0.0, kLongestStep) : 0;
    // What is no number would stay so for ever.
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
