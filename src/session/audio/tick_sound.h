// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "haptics/haptic_simulation.h"
#include "instruments/bur_catalogue.h"
#include "sound/voices/drill_sound_state.h"

namespace tactooth {

/// The kind of a drive's tones.
[[nodiscard]] MotorKind motorOf(const SpindlePreset& spindle);

/// The sound of a tick with this drive, bur and materials. The spray follows the pedal; the suction runs while cutting
/// is on. Allocates nothing, so the servo thread may call it.
[[nodiscard]] DrillSoundState soundOf(const Tick& tick, const SpindlePreset& spindle,
                                      const MaterialTable& materials = MaterialTable(), const BurEdge& edge = {});

}  // namespace tactooth
