// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/audio/tick_sound.h"

#include <algorithm>

#include "instruments/handpiece_kind.h"
#include "session/audio/material_sound.h"

namespace tactooth {
namespace {

constexpr double kCoarsestGrit = 180;  // um: a super-coarse diamond crackles, a super-fine one hisses
constexpr double kMaxGrainier = 0.5;   // of the difference to graininess 1

}  // namespace

MotorKind motorOf(const SpindlePreset& spindle) {
    if (spindle.pedalCurve == PedalCurve::Electric) return MotorKind::Electric;
    return handpieceOf(spindle) == HandpieceKind::Turbine ? MotorKind::AirTurbine : MotorKind::LowSpeed;
}

TickSound::TickSound(const SpindlePreset& spindle, const MaterialTable& materials, const BurEdge& edge)
    : motor_(motorOf(spindle)),
      freeSpeedRpm_(spindle.freeSpeedRpm),
      stallTorque_(spindle.stallTorque),
      blades_(edge.flutes) {
    const double coarseness = std::clamp(edge.gritMicrometres / kCoarsestGrit, 0.0, 1.0);
    for (const MaterialId id : materials.registry().ids()) {
        SoundCharacter& character = characters_[static_cast<std::size_t>(id)] = characterOf(materials, id);
        character.graininess += kMaxGrainier * coarseness * (1 - character.graininess);
    }
}

DrillSoundState TickSound::at(const Tick& tick) const {
    DrillSoundState state;
    state.motor = motor_;
    state.speedRpm = tick.spindle.speedRpm;
    state.freeSpeedRpm = freeSpeedRpm_;
    state.pedal = tick.input.cutting ? tick.input.pedal : 0;  // in touch mode the pedal has no effect
    state.load = std::clamp(tick.spindle.load / stallTorque_, 0.0, 1.0);
    state.removalPower = tick.spindle.removalPower;
    state.material = characters_[static_cast<std::size_t>(tick.contact.material)];
    state.blades = blades_;
    state.contactCount = tick.contact.onsets;
    state.contactSpeed = tick.contact.impactSpeed;
    state.pullOutCount = tick.contact.pullOuts;
    state.pullOutForce = tick.contact.pullOutForce;
    state.contactForce = tick.force.wrench.force.norm();
    state.slideSpeed = tick.contact.slideSpeed;
    state.water = state.pedal;
    state.suction = tick.input.cutting ? 1 : 0;
    return state;
}

DrillSoundState soundOf(const Tick& tick, const SpindlePreset& spindle, const MaterialTable& materials,
                        const BurEdge& edge) {
    return TickSound(spindle, materials, edge).at(tick);
}

}  // namespace tactooth
