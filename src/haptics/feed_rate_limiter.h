// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/pose.h"

namespace tactooth {

/// Lets a cutting bur go on at the pace of its cut. A new surface gives way by what was cut since the last one, all at
/// once: a bur that leapt into that room would knock at the rate of the surfaces. It takes about as long over
/// it as the cut did, so that force and feed are steady.
class FeedRateLimiter {
public:
    /// A new surface leaves the bur `way` (mm) to go.
    void allow(double way);

    /// To be called each tick: seconds go by.
    void pass(double dt) { sinceGrant_ += dt; }

    /// Where a bur that cuts shall go in a tick of `dt` seconds: toward the hand at the pace of the cut, or as fast as
    /// the hand itself, and faster where it hangs back by more than half a millimetre; across that direction as the
    /// hand does. `deviceStep`: of the hand in this tick, mm.
    [[nodiscard]] Pose goal(const Pose& hand, const Pose& bur, const Vec3& deviceStep, double dt) const;

    /// What a tick that had no time left for it has left of its way, mm: the next one goes that far as well.
    void carryOver(double way);

private:
    double sinceGrant_ = 0;   // s
    double feedRate_ = 0;     // mm/s
    double carriedOver_ = 0;  // mm
};

}  // namespace tactooth
