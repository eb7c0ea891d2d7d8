// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/vec.h"

namespace tactooth {

/// What pushes at one tick: a spring, and how much of it comes out.
struct SpringState {
    double deflection = 0;  ///< mm
    double stiffness = 0;   ///< N/mm
    double bound = 0;       ///< N: the spring's force is cut off here
    double strength = 1;    ///< 0..1: and then multiplied by this
};

/// Watches the energy that passes between hand and tooth, and takes out by damping what the loop's sampling puts in.
///
/// A spring that is felt at ticks gives back more than it took: it pushes out a tick too long. What the hand has put
/// in, less what the spring holds, must not fall below zero; where the next step of the hand could make it, a damper is
/// switched in that eats the difference.
class PassivityController {
public:
    /// `friction`: of the device's own mechanics, N; what it eats pays for a part of the leak.
    explicit PassivityController(double friction = 0) : friction_(friction) {}

    /// One tick in contact. `hand`: where it is now, mm; `rendered`: the force since the last tick, N. Gives the force
    /// to add, N; one that is no number if its own sums are none, which then begin anew.
    [[nodiscard]] Vec3 damp(const Vec3& hand, const Vec3& rendered, const SpringState& spring, double elapsed);

    /// Forgets everything; for a tick without contact.
    void reset();

    /// What the hand has put in and the tooth does not hold, N*mm; bounded above.
    [[nodiscard]] double energy() const { return energy_; }

private:
    void updateSpeed(const Vec3& displacement, double elapsed);
    [[nodiscard]] bool isValid() const;

    double friction_;
    bool started_ = false;
    double energy_ = 0;
    double reserve_ = 0;         // N*mm that the next step may leak, if it is as long as the last ones
    Vec3 step_ = Vec3::Zero();   // the last in which the hand moved, mm
    double pause_ = 0;           // s that it took
    double idle_ = 0;            // s since then
    Vec3 speed_ = Vec3::Zero();  // low-passed, mm/s
    double damping_ = 0;         // N*s/mm, of the last tick
    double lastDeflection_ = 0;
    double lastStiffness_ = 0;
    Vec3 lastDevice_ = Vec3::Zero();
};

}  // namespace tactooth
