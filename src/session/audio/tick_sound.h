// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "haptics/haptic_simulation.h"
#include "instruments/bur_catalogue.h"
#include "sound/voices/drill_sound_state.h"

namespace tactooth {

/// The kind of a drive's tones.
[[nodiscard]] MotorKind motorOf(const SpindlePreset& spindle);

/// The sound of ticks with one drive, bur and table of materials.
class TickSound {
public:
    explicit TickSound(const SpindlePreset& spindle, const MaterialTable& materials = MaterialTable(),
                       const BurEdge& edge = {});

    /// The sound of a tick. The spray follows the pedal; the suction runs while cutting is on. Allocates nothing, so
    /// the servo thread may call it.
    [[nodiscard]] DrillSoundState at(const Tick& tick) const;

private:
    MotorKind motor_;
    double freeSpeedRpm_;
    double stallTorque_;  // N*mm
    int blades_;
    std::array<SoundCharacter, kMaxMaterials> characters_{};  // by MaterialId
};

/// The same for a single tick.
[[nodiscard]] DrillSoundState soundOf(const Tick& tick, const SpindlePreset& spindle,
                                      const MaterialTable& materials = MaterialTable(), const BurEdge& edge = {});

}  // namespace tactooth
