// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/pose.h"

namespace tactooth {

/// Commanded velocity of a tool under rate control, in the device's frame.
struct RateCommand {
    Vec3 speed = Vec3::Zero();  ///< mm/s
    Vec3 turn = Vec3::Zero();   ///< angular velocity, rad/s about the device's axes
};

/// Rate control for self-centring devices: sticks, a SpaceMouse. Integrates the commanded velocity to a device pose.
/// The pose yields to the contact force as a hand does: a larger deflection presses harder, and the tool soon leaves
/// the tooth after the user releases the stick.
class RateController {
public:
    /// Travel from the middle to each side, mm.
    static constexpr double kReach = 20;

    /// Device pose `elapsed` s later.
    [[nodiscard]] Pose advance(const RateCommand& asked, double elapsed);
    /// Contact force on the tool, N, in the device's frame. Takes effect from the next step.
    void setForce(const Vec3& force) { force_ = force; }

private:
    Pose hand_;
    RateCommand rate_;  // smoothed
    Vec3 force_ = Vec3::Zero();
};

}  // namespace tactooth
