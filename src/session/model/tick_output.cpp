// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/tick_output.h"

#include <utility>

#include "session/audio/tick_sound.h"
#include "session/live/live_stream.h"

namespace tactooth {

void TickOutput::streamTo(std::shared_ptr<LiveStream> stream) { stream_ = std::move(stream); }

LiveRunner::TickListener TickOutput::listener(const HapticSettings& haptics, const BurEdge& edge) {
    return [this, stream = stream_, tickSound = TickSound(haptics.spindle, haptics.materials, edge)](const Tick& tick) {
        DrillSoundState heard = tickSound.at(tick);
        instruments_.muteIdle(heard);
        sound_.publish(heard);
        if (stream != nullptr && streamAllowed_) stream->write(tick);
    };
}

}  // namespace tactooth
