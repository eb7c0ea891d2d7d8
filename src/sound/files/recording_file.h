// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

#include "sound/files/recording.h"

namespace tactooth {

/// Reads a WAV, FLAC or Ogg file as a loop; of up to eight channels it takes the mean. A WAV file that was written
/// through a pipe, without its length, is read to its end. Fails with one sentence that names the file if it is
/// missing, of another kind, cut off, or refused by Recording::make().
[[nodiscard]] Expected<Recording> readRecording(const std::filesystem::path& path);

/// The same from memory; `name` is the name of the file in messages.
[[nodiscard]] Expected<Recording> parseRecording(std::span<const std::byte> bytes, std::string_view name);

}  // namespace tactooth
