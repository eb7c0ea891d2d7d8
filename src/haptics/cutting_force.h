// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/vec.h"

namespace tactooth {

/// Of the normal force: how hard the cut pulls at the rim, against the rotation (measured on glass ceramic: 0.4 to 0.6
/// between 0.6 and 2.9 N).
inline constexpr double kTangentialRatio = 0.5;

/// Of the normal force: how hard a cut shakes, 40 mN at 1 N, about what a hand just feels as a shake.
inline constexpr double kVibrationRatio = 0.04;

/// A bur that turns slower, rev/min, rubs and does not cut.
inline constexpr double kMinCuttingRpm = 300;

/// A turning bur in contact, in the tooth's frame.
struct CuttingContact {
    Vec3 normal;          ///< unit, out of the tooth
    Vec3 axis;            ///< unit, of the bur, from its tip to its shaft
    double normalForce;   ///< N; 0 without contact
    double speedRpm;      ///< of the bur
    double freeSpeedRpm;  ///< of its drive without load
};

/// What a cut adds to the force of contact: it pulls the bur along its rim, against the rotation (clockwise, seen from
/// the shaft), and shakes it. Both grow with the normal force and come and go within some tens of milliseconds.
class CuttingForce {
public:
    /// In N, `dt` seconds after the call before.
    [[nodiscard]] Vec3 at(const CuttingContact& contact, double dt);

    /// How fast a bur shakes the hand, Hz: once a turn, or as many octaves lower as the drive's free speed is above
    /// what a hand feels and a device can follow. So the pitch falls as the bur slows down under its load.
    [[nodiscard]] static double vibrationFrequency(double speedRpm, double freeSpeedRpm);

private:
    double engagement_ = 0;  // 0 still or in the air .. 1 cutting
    double phase_ = 0;       // of the shaking, rad
};

}  // namespace tactooth
