// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "geometry/util/expected.h"
#include "instruments/spindle.h"
#include "sound/voices/sound_kit.h"
#include "tooth/model/material_registry.h"

namespace tactooth {

/// Reads the user's sounds: a preset (TOML, pattern: docs/sound.md) that names a recording for each part, or a single
/// recording (any other file) of `drive` running free. The preset may name these materials; null: any material, for a
/// tooth that is not there yet.
///
/// Fails with one sentence with file and line: no TOML, an unknown part, key or material, a number out of range, a
/// missing `file` or one outside the preset's folder, and everything that readRecording refuses.
[[nodiscard]] Expected<std::shared_ptr<const SoundKit>> readSoundKit(const std::filesystem::path& path,
                                                                     const SpindlePreset& drive,
                                                                     const MaterialRegistry* materials);

/// Reads a recording by its path in a preset.
using RecordingReader = std::function<Expected<Recording>(const std::string& path)>;

/// A preset from memory; `name` stands for the file in messages.
[[nodiscard]] Expected<SoundKit> parseSoundPreset(std::string_view text, const std::string& name,
                                                  const MaterialRegistry* materials, const RecordingReader& readNamed);

}  // namespace tactooth
