// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/voices/recorded_voice.h"

namespace tactooth {

void RecordedVoice::addTo(std::span<float> out, const RecordedPart& part, double level, float share,
                          std::span<const double> turnsPerFrame) {
    gain_.aim(static_cast<float>(level * part.gain), share, static_cast<int>(out.size()));
    if (gain_.isZero()) return;
    const double framesPerTurn = part.speedRpm > 0.0 ? 60.0 * kSoundRate / part.speedRpm : 0.0;
    for (std::size_t i = 0; i < out.size(); ++i) {
        const double pitch = framesPerTurn > 0.0 ? turnsPerFrame[i] * framesPerTurn : 1.0;
        out[i] += gain_.next() * player_.next(*part.recording, pitch);
    }
}

}  // namespace tactooth
