// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

#include "sound/files/recording.h"

namespace tactooth {

/// Reads a WAV, FLAC or Ogg file, of whose channels (at most eight) the mean is taken, as a loop. A WAV file
/// that was written through a pipe, and does not know how long it is, is read to its end. Fails with one sentence that
/// names the file if it is missing, of another kind, cut off, or one that Recording::make() refuses.
[[nodiscard]] Expected<Recording> readRecording(const std::filesystem::path& path);

/// The same from memory; `name` stands for the file in messages.
[[nodiscard]] Expected<Recording> parseRecording(std::span<const std::byte> bytes, std::string_view name);

}  // namespace tactooth
