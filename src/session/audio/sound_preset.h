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

namespace tactooth {

/// Reads the user's own sounds: a preset (TOML, pattern: docs/sound.md) that says which recording stands for what, or a
/// recording alone (any other file), which then is `drive` running free.
///
/// Fails with one sentence with file and line on a preset that is not TOML, a part, key or material that there is not,
/// a number that cannot be meant, a missing `file` or one that lies outside of the preset's folder; and on everything
/// that readRecording refuses.
[[nodiscard]] Expected<std::shared_ptr<const SoundKit>> readSoundKit(const std::filesystem::path& path,
                                                                     const SpindlePreset& drive);

/// Reads a recording by the path that stands in a preset.
using RecordingReader = std::function<Expected<Recording>(const std::string& path)>;

/// A preset from memory; `name` stands for the file in messages.
[[nodiscard]] Expected<SoundKit> parseSoundPreset(std::string_view text, const std::string& name,
                                                  const RecordingReader& readNamed);

}  // namespace tactooth
