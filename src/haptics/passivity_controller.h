// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/vec.h"

namespace tactooth {

/// The spring that pushes at one tick, and how much of its force is rendered.
struct SpringState {
    double deflection = 0;  ///< mm
    double stiffness = 0;   ///< N/mm
    double bound = 0;       ///< the force of the spring is limited to this, N
    double strength = 1;    ///< factor on the limited force, 0..1
};

/// Time-domain passivity observer and controller (Hannaford & Ryu 2002). It sums the energy that passes between hand
/// and tooth, and removes by damping the energy that sampling adds.
///
/// A spring that is computed once a tick returns more energy than it took, because its force is held for one tick too
/// long. The energy that the hand has put in, less the energy that the spring stores, must not fall below zero. Where
/// the next step of the hand could make it negative, the controller adds a damper that removes the difference.
class PassivityController {
public:
    /// `friction` is that of the device's own mechanics, N, finite and not negative. The energy that it removes
    /// makes up for a part of the leak.
    explicit PassivityController(double friction = 0);

    /// One tick in contact. `device` is the present position of the device, mm; `rendered` is the force since the last
    /// tick, N. Returns the force to add, N. If the sums are not finite, it returns NaN and starts anew.
    [[nodiscard]] Vec3 damp(const Vec3& device, const Vec3& rendered, const SpringState& spring, double elapsed);

    /// Forgets everything. Call it at a tick without contact.
    void reset();

    /// The energy that the hand has put in and the spring does not store, N*mm; bounded above.
    [[nodiscard]] double energy() const { return energy_; }

private:
    void updateSpeed(const Vec3& displacement, double elapsed);
    [[nodiscard]] bool isValid() const;

    double friction_;
    bool started_ = false;
    double energy_ = 0;
    double reserve_ = 0;         // N*mm that the next step may leak, if it is as long as the last ones
    Vec3 step_ = Vec3::Zero();   // the last step in which the hand moved, mm
    double pause_ = 0;           // s, the duration of that step
    double idle_ = 0;            // s since that step
    Vec3 speed_ = Vec3::Zero();  // low-passed, mm/s
    double damping_ = 0;         // N*s/mm at the last tick
    double lastDeflection_ = 0;
    double lastStiffness_ = 0;
    Vec3 lastDevice_ = Vec3::Zero();
};

}  // namespace tactooth
