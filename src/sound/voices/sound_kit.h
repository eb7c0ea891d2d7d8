// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "sound/files/recording.h"
#include "sound/voices/drill_sound_state.h"

namespace tactooth {

/// A recording that replaces a synthesised sound.
struct RecordedPart {
    std::shared_ptr<const Recording> recording;
    double speedRpm = 0.0;  ///< speed of the bur in the recording, which the pitch follows; 0: constant pitch
    double gain = 1.0;      ///< relative to the level of the synthesised sound
};

/// The sounds that are recordings; all others are synthesised.
struct SoundKit {
    std::optional<RecordedPart> motor;                                 ///< its tones and its air
    std::array<std::optional<RecordedPart>, kSoundMaterials> cutting;  ///< by SoundCharacter::kind
    std::optional<RecordedPart> water, suction;
};

}  // namespace tactooth
