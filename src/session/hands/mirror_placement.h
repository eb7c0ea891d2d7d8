// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/util/pose.h"
#include "session/hands/pointer_view.h"

namespace tactooth {

/// Where the mouth mirror is held by the mouse. Until it has been moved, it is where it was parked. Poses are those of
/// the mirror's frame (see DentalMirror) in the tooth's frame.
class MirrorPlacement {
public:
    /// Where the mirror waits while nobody has moved it.
    void park(const Pose& parked) { parked_ = parked; }
    /// Back to where it waits.
    void reset() { held_.reset(); }
    void place(const Pose& pose) { held_ = pose; }
    [[nodiscard]] const Pose& pose() const { return held_ ? *held_ : parked_; }

    /// The mouse goes from one pixel to another: the glass follows it, at the same distance from the eye.
    void drag(const PointerView& picture, const Vec2& from, const Vec2& to);
    /// Tilts the glass about its centre by (dx, dy) pixels: it turns to where the mouse goes.
    void tilt(const PointerView& picture, const Vec2& pixels);
    /// Toward the eye, mm; away from it with a negative number.
    void approach(const PointerView& picture, double distance);

    /// mm from where it waits; further away nothing of the mouth is seen in it.
    static constexpr double kReach = 40;

private:
    void moveTo(const Vec3& centre);

    Pose parked_;
    std::optional<Pose> held_;
};

}  // namespace tactooth
