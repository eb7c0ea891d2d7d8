// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/audio/tick_sound.h"

#include <algorithm>

namespace tactooth {
namespace {

constexpr double kTurbineFromRpm = 100000;  // air drives: turbines run at 200,000 and more, air motors below 40,000
constexpr double kCoarsestGrit = 180;       // um: a super-coarse diamond tears grains out, a super-fine one hisses
constexpr double kMaxGrainier = 0.5;        // of what is missing to separate grains

}  // namespace

MotorKind motorOf(const SpindlePreset& spindle) {
    if (spindle.pedalCurve == PedalCurve::Electric) return MotorKind::Electric;
    return spindle.freeSpeedRpm >= kTurbineFromRpm ? MotorKind::AirTurbine : MotorKind::LowSpeed;
}

DrillSoundState soundOf(const Tick& tick, const SpindlePreset& spindle, const MaterialTable& materials,
                        const BurEdge& edge) {
    DrillSoundState state;
    state.motor = motorOf(spindle);
    state.speedRpm = tick.speedRpm;
    state.freeSpeedRpm = spindle.freeSpeedRpm;
    state.pedal = tick.cutting ? tick.pedal : 0;  // in touch mode the pedal drives nothing
    state.load = std::clamp(tick.load / spindle.stallTorque, 0.0, 1.0);
    state.removalPower = tick.removalPower;
    state.material = soundCharacterOf(materialName(tick.material));
    state.material.bandCentreHz = materials[tick.material].soundCentre;
    state.material.level = materials[tick.material].soundBrightness;
    const double coarseness = std::clamp(edge.gritMicrometres / kCoarsestGrit, 0.0, 1.0);
    state.material.graininess += kMaxGrainier * coarseness * (1 - state.material.graininess);
    state.blades = edge.flutes;
    state.contactCount = tick.contactOnsets;
    state.contactSpeed = tick.impactSpeed;
    state.water = state.pedal;
    state.suction = tick.cutting ? 1 : 0;
    return state;
}

}  // namespace tactooth
