// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "sound/files/recording.h"
#include "sound/voices/drill_sound_state.h"

namespace tactooth {

/// A recording in the place of a synthesised sound.
struct RecordedPart {
    std::shared_ptr<const Recording> recording;
    double speedRpm = 0.0;  ///< of the bur when it was recorded, which the pitch follows; 0: the pitch stays
    double gain = 1.0;      ///< against the synthesised sound's level
};

/// Which sounds are recordings; what is not there is synthesised.
struct SoundKit {
    std::optional<RecordedPart> motor;                                 ///< its tones and its air
    std::array<std::optional<RecordedPart>, kSoundMaterials> cutting;  ///< by SoundCharacter::kind
    std::optional<RecordedPart> water, suction;
};

}  // namespace tactooth
