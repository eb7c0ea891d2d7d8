// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/mouse/mouse_device.h"

#include <cmath>

namespace tactooth {
namespace {

constexpr double kFollowRate = 60;  // 1/s, critically damped: within 5 % of a step after 80 ms, smooth at 1 kHz

}  // namespace

MouseDevice::MouseDevice(const Pose& start) : target_(DeviceSample{start, 0, 0, true}), hand_(start) {
    info_.name = "mouse";
    info_.poseLimits = PoseLimits::unlimited();
    info_.hasPedal = true;
    info_.buttonCount = 2;
}

/// The exact step of a critically damped spring, stable for any `elapsed`.
DeviceSample MouseDevice::read(double elapsed) {
    target_.refresh();
    DeviceSample sample = target_.value();
    const Pose& target = sample.hand;
    if (!target.position.allFinite() || !target.rotation.coeffs().allFinite() || !std::isfinite(elapsed)) {
        sample.hand = hand_;  // else the pose would stay NaN for ever
        return sample;
    }
    const Vec3 away = hand_.position - sample.hand.position;
    const Vec3 rate = velocity_ + kFollowRate * away;
    const double decay = std::exp(-kFollowRate * elapsed);
    hand_.position = sample.hand.position + decay * (away + elapsed * rate);
    velocity_ = decay * (velocity_ - elapsed * kFollowRate * rate);
    hand_.rotation = hand_.rotation.slerp(1 - decay, sample.hand.rotation).normalized();
    sample.hand = hand_;
    return sample;
}

void MouseDevice::write(const SafeWrench&) {}

}  // namespace tactooth
