// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/audio/material_sound.h"

#include <functional>

#include "session/io/material_file.h"

namespace tactooth {

std::size_t soundKindOf(std::string_view material) { return std::hash<std::string_view>{}(material); }

SoundCharacter characterOf(const MaterialTable& materials, MaterialId id) {
    const Material& material = materials[id];
    const MaterialRegistry& registry = materials.registry();
    const MaterialId standIn =
        dentalMaterials().find(registry.nameOf(id)) ? id : registry.withRole(MaterialRole::Surroundings);
    return {.bandCentreHz = material.soundCentre,
            .bandOctaves = material.soundOctaves,
            .level = material.soundBrightness,
            .graininess = material.soundGraininess,
            .tapHz = material.tapFrequency,
            .tapDecay = material.tapDecay,
            .tapBrightness = material.tapBrightness,
            .kind = soundKindOf(registry.nameOf(id)),
            .standIn = soundKindOf(registry.nameOf(standIn))};
}

}  // namespace tactooth
