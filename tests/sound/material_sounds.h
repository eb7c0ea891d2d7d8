// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "sound/voices/drill_sound_state.h"

namespace tactooth::test {

/// How a material sounds that the program knows by name.
[[nodiscard]] SoundCharacter characterOf(std::string_view material);

/// A turbine at a steady speed that cuts this material.
[[nodiscard]] DrillSoundState cutting(std::string_view material, double watt, double speedRpm = 300000.0);

}  // namespace tactooth::test
