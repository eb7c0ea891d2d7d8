// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/voices/drill_sound_state.h"

#include <algorithm>
#include <cmath>

namespace tactooth {

namespace {

constexpr double kTopSpeedRpm = 1.0e6;    // twice the fastest turbine on sale
constexpr double kTopRemovalWatt = 1000;  // a turbine gives 30 W at most
constexpr double kTopContactSpeed = 1e4;  // mm/s: faster than any hand
constexpr double kTopContactForce = 100;  // N: more than any hand presses
constexpr int kMaxBlades = 60;            // finishing burs have 30

double within(double value, double low, double high, double otherwise) {
    return std::isfinite(value) ? std::clamp(value, low, high) : otherwise;
}

SoundCharacter sanitisedCharacter(const SoundCharacter& character) {
    const SoundCharacter usual;
    return {.bandCentreHz = within(character.bandCentreHz, 50.0, 16000.0, usual.bandCentreHz),
            .bandOctaves = within(character.bandOctaves, 0.1, 4.0, usual.bandOctaves),
            .level = within(character.level, 0.0, 1.0, 0.0),
            .graininess = within(character.graininess, 0.0, 1.0, 0.0),
            .tapHz = within(character.tapHz, 50.0, 16000.0, usual.tapHz),
            .tapDecay = within(character.tapDecay, 0.0005, 0.1, usual.tapDecay),
            .tapBrightness = within(character.tapBrightness, 0.0, 1.0, 0.0),
            .kind = character.kind,
            .standIn = character.standIn};
}

}  // namespace

DrillSoundState sanitised(const DrillSoundState& state) {
    DrillSoundState safe = state;
    safe.speedRpm = within(std::abs(state.speedRpm), 0.0, kTopSpeedRpm, 0.0);
    safe.freeSpeedRpm = within(state.freeSpeedRpm, 1.0, kTopSpeedRpm, kTopSpeedRpm);
    safe.pedal = within(state.pedal, 0.0, 1.0, 0.0);
    safe.load = within(state.load, 0.0, 1.0, 0.0);
    safe.removalPower = within(state.removalPower, 0.0, kTopRemovalWatt, 0.0);
    safe.blades = std::clamp(state.blades, 0, kMaxBlades);
    safe.contactSpeed = within(state.contactSpeed, 0.0, kTopContactSpeed, 0.0);
    safe.pullOutForce = within(state.pullOutForce, 0.0, kTopContactForce, 0.0);
    safe.contactForce = within(state.contactForce, 0.0, kTopContactForce, 0.0);
    safe.slideSpeed = within(state.slideSpeed, 0.0, kTopContactSpeed, 0.0);
    safe.water = within(state.water, 0.0, 1.0, 0.0);
    safe.suction = within(state.suction, 0.0, 1.0, 0.0);
    safe.material = sanitisedCharacter(state.material);
    return safe;
}

}  // namespace tactooth
