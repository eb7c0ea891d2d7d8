// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string_view>

#include "sound/files/messages.h"
#include "sound/output/sound_placement.h"
#include "sound/voices/drill_sound_state.h"
#include "sound/voices/sound_kit.h"
#include "sound/voices/sound_mixer.h"

namespace tactooth {

enum class SoundStatus { Starting, Playing, Silent };

/// A few words for a status line.
[[nodiscard]] constexpr const MessageText& statusText(SoundStatus status) {
    switch (status) {
        case SoundStatus::Starting:
            return msg::kSoundStarting;
        case SoundStatus::Playing:
            return msg::kSoundOn;
        case SoundStatus::Silent:
            return msg::kNoSoundCard;
    }
    return msg::kNoSoundCard;
}

/// Output of the drill's sound. No call waits or fails; without a sound card everything works, silently.
class SoundOutput {
public:
    SoundOutput() = default;
    SoundOutput(const SoundOutput&) = delete;
    SoundOutput& operator=(const SoundOutput&) = delete;
    virtual ~SoundOutput() = default;

    /// Sets the newest state of the drill. One thread (the simulation's), any rate; wait-free. When the calls stop, the
    /// drill falls silent, as when the simulation is paused.
    virtual void publish(const DrillSoundState& state) = 0;

    /// Sets the volumes. One thread (the window's); wait-free.
    virtual void setMixer(const SoundMixer& mixer) = 0;
    virtual void setPlacement(const SoundPlacement& placement) = 0;
    /// Whether the sound is placed by HRTF, for headphones, or by left-right balance. The sound stops for a moment at a
    /// change.
    virtual void setHeadphones(bool headphones) = 0;
    /// Whether the surgery is heard around the drill. The sound stops for a moment at a change.
    virtual void setRoom(bool room) = 0;

    /// Recordings to play from now on; null: all synthesised.
    virtual void setKit(std::shared_ptr<const SoundKit> kit) = 0;

    /// Any thread.
    [[nodiscard]] virtual SoundStatus status() const = 0;
};

}  // namespace tactooth
