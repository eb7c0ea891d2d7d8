// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "sound/files/recording.h"
#include "sound/voices/drill_sound_state.h"

namespace tactooth {

/// A recording that replaces a synthesised sound.
struct RecordedPart {
    std::shared_ptr<const Recording> recording;
    double speedRpm = 0.0;  ///< speed of the bur in the recording, which the pitch follows; 0: constant pitch
    double gain = 1.0;      ///< relative to the level of the synthesised sound
};

/// The most materials that have recordings: the voices have room for as many.
inline constexpr std::size_t kMaxRecordedMaterials = 32;

/// A recording that replaces the cutting noise of a material.
struct RecordedMaterial {
    std::size_t kind = 0;  ///< see SoundCharacter
    RecordedPart part;
};

/// The sounds that are recordings; all others are synthesised.
struct SoundKit {
    std::optional<RecordedPart> motor;      ///< its tones and its air
    std::vector<RecordedMaterial> cutting;  ///< no kind twice, at most kMaxRecordedMaterials
    std::optional<RecordedPart> water, suction;

    /// The index in `cutting` of the recording for a material: its own, else that of its stand-in. The size of
    /// `cutting` if there is neither.
    [[nodiscard]] std::size_t cuttingOf(const SoundCharacter& material) const {
        const std::size_t own = indexOf(material.kind);
        return own < cutting.size() ? own : indexOf(material.standIn);
    }

private:
    [[nodiscard]] std::size_t indexOf(std::size_t kind) const {
        const auto found = std::ranges::find(cutting, kind, &RecordedMaterial::kind);
        return static_cast<std::size_t>(found - cutting.begin());
    }
};

}  // namespace tactooth
