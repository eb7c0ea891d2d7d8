// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "haptics/haptic_simulation.h"
#include "instruments/bur_catalogue.h"
#include "sound/voices/drill_sound_state.h"

namespace tactooth {

/// Which of the three kinds of tones a drive has.
[[nodiscard]] MotorKind motorOf(const SpindlePreset& spindle);

/// How a tick sounds with this drive and bur in these materials: the spray comes with the pedal, and the assistant
/// holds the suction in the mouth as long as cutting is on. Allocates nothing: fit for the servo thread.
[[nodiscard]] DrillSoundState soundOf(const Tick& tick, const SpindlePreset& spindle,
                                      const MaterialTable& materials = MaterialTable(), const BurEdge& edge = {});

}  // namespace tactooth
