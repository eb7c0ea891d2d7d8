// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/pose.h"

namespace tactooth {

/// Limits the feed of a cutting bur to the rate of its cut. A new surface frees at once the space of all that was cut
/// since the last surface. A bur that jumped into that space would vibrate at the rate of the surfaces. The limiter
/// lets the bur take about as long as the cut took, so that force and feed are steady.
class FeedRateLimiter {
public:
    /// Reports a new surface into which the bur may advance by `distance`, mm.
    void allow(double distance);

    /// Reports the end of a tick of `dt` s.
    void pass(double dt);

    /// The goal of a cutting bur in a tick of `dt` s. The bur moves toward the device at the rate of the cut, or as
    /// fast as the device, and faster if it lags behind by more than half a millimetre. Across that direction it moves
    /// as the device does. `deviceStep` is the step of the device in this tick, mm.
    [[nodiscard]] Pose goal(const Pose& device, const Pose& bur, const Vec3& deviceStep, double dt) const;

    /// Adds to the next goal the distance, mm, that the bur could not move in this tick because its work budget ran
    /// out.
    void carryOver(double distance);

private:
    double sinceGrant_ = 0;   // s
    double feedRate_ = 0;     // mm/s
    double carriedOver_ = 0;  // mm
};

}  // namespace tactooth
