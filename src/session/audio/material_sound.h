// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>

#include "sound/voices/drill_sound_state.h"
#include "tooth/model/material_registry.h"

namespace tactooth {

/// The kind of a material's sound (see SoundCharacter). It follows from the name alone, as recordings are for all
/// teeth: the same material may have another MaterialId in another tooth.
[[nodiscard]] std::size_t soundKindOf(std::string_view material);

/// How a material sounds. The recording of the surroundings stands in for that of a material which dentalMaterials()
/// does not name.
[[nodiscard]] SoundCharacter characterOf(const MaterialTable& materials, MaterialId id);

}  // namespace tactooth
