// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "instruments/spindle.h"

namespace tactooth {

/// The handpieces by their heads.
enum class HandpieceKind {
    Turbine,      ///< small head, slender neck (makeTurbine)
    ContraAngle,  ///< on an electric motor, red ring: small head, wide coupling (makeContraAngle)
    LowSpeed      ///< on an air motor, blue ring: large head with a latch, thick neck (makeLowSpeedHandpiece)
};

/// The handpiece that a drive needs: a turbine is its own; motors turn the bur through a contra-angle.
[[nodiscard]] inline HandpieceKind handpieceOf(const SpindlePreset& drive) {
    constexpr double kTurbineFromRpm = 100'000;  // turbines run at 200,000 and more, air motors below 40,000
    if (drive.pedalCurve == PedalCurve::Electric) return HandpieceKind::ContraAngle;
    return drive.freeSpeedRpm >= kTurbineFromRpm ? HandpieceKind::Turbine : HandpieceKind::LowSpeed;
}

}  // namespace tactooth
