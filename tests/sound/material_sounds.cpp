// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/material_sounds.h"

#include "session/audio/material_sound.h"
#include "session/io/material_file.h"
#include "sound/spectrum.h"

namespace tactooth::test {

SoundCharacter characterOf(std::string_view material) {
    const MaterialTable materials(dentalMaterials());
    return tactooth::characterOf(materials, materials.registry().find(material).value());
}

DrillSoundState cutting(std::string_view material, double watt, double speedRpm) {
    DrillSoundState state = spinning(speedRpm);
    state.load = 0.25;
    state.removalPower = watt;
    state.material = characterOf(material);
    return state;
}

}  // namespace tactooth::test
