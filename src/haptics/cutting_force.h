// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/vec.h"

namespace tactooth {

/// Tangential force of a cut as a share of the normal force; it acts at the rim, against the rotation (measured on
/// glass ceramic: 0.4 to 0.6 between 0.6 and 2.9 N).
inline constexpr double kTangentialRatio = 0.5;

/// Vibration of a cut as a share of the normal force: 40 mN at 1 N, about the smallest vibration that a hand feels.
inline constexpr double kVibrationRatio = 0.04;

/// A bur that turns more slowly, rev/min, rubs and does not cut.
inline constexpr double kMinCuttingRpm = 300;

/// A turning bur in contact, in the tooth's frame.
struct CuttingContact {
    Vec3 normal;          ///< unit, out of the tooth
    Vec3 axis;            ///< of the bur, unit, from its tip to its shaft
    double normalForce;   ///< N; 0 without contact
    double speedRpm;      ///< of the bur
    double freeSpeedRpm;  ///< free speed of its drive
};

/// The force that a cut adds to the contact force. It pulls the bur along its rim, against the rotation (clockwise,
/// seen from the shaft), and makes it vibrate. Both parts grow with the normal force, and come and go within some tens
/// of milliseconds.
class CuttingForce {
public:
    /// The force, N, in the tooth's frame, `dt` s after the last call.
    [[nodiscard]] Vec3 at(const CuttingContact& contact, double dt);

    /// Vibration frequency of a bur, Hz: its rotation frequency, halved as often as it takes to bring that of the
    /// drive's free speed below 250 Hz, which a hand feels and a device can render. So the frequency falls when the bur
    /// slows down under load.
    [[nodiscard]] static double vibrationFrequency(double speedRpm, double freeSpeedRpm);

private:
    double engagement_ = 0;  // 0 at rest or in the air .. 1 cutting
    double phase_ = 0;       // of the vibration, rad
};

}  // namespace tactooth
