// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/pose.h"

namespace tactooth {

/// What a person wants of a tool that is steered by speed, in the device's frame.
struct RateCommand {
    Vec3 speed = Vec3::Zero();  ///< mm/s
    Vec3 turn = Vec3::Zero();   ///< rad/s about the device's axes
};

/// A hand that is steered by speed, for devices that go back to their middle: sticks, a SpaceMouse. It gives way to the
/// force that it meets, as a hand does: pushing further presses harder, and who lets go is soon out of the tooth.
class RateController {
public:
    /// Of the way from the middle to each side, mm.
    static constexpr double kReach = 20;

    /// Where the hand is `elapsed` s later.
    [[nodiscard]] Pose advance(const RateCommand& asked, double elapsed);
    /// What the tool meets, N, device's frame; counts from the next step on.
    void setForce(const Vec3& force) { force_ = force; }

private:
    Pose hand_;
    RateCommand rate_;  // smoothed
    Vec3 force_ = Vec3::Zero();
};

}  // namespace tactooth
