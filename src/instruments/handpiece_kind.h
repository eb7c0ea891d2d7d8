// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "instruments/spindle.h"

namespace tactooth {

/// The handpieces by their heads.
enum class HandpieceKind {
    Turbine,     ///< small head, slender neck (makeTurbine)
    ContraAngle  ///< on a motor: latch, wide coupling (makeContraAngle)
};

/// The handpiece that a drive needs: a turbine is its own; motors, electric or by air, turn the bur through a
/// contra-angle.
[[nodiscard]] inline HandpieceKind handpieceOf(const SpindlePreset& drive) {
    constexpr double kTurbineFromRpm = 100'000;  // turbines run at 200,000 and more, air motors below 40,000
    const bool isTurbine = drive.pedalCurve == PedalCurve::Air && drive.freeSpeedRpm >= kTurbineFromRpm;
    return isTurbine ? HandpieceKind::Turbine : HandpieceKind::ContraAngle;
}

}  // namespace tactooth
