// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

#include "geometry/expected.h"

namespace tactooth {

/// Left and right samples by turns, at kSoundRate, as a 16-bit WAV file in memory. Samples beyond +-1 are held there.
/// Error: more than the 4 GB that such a file can hold.
[[nodiscard]] Expected<std::vector<std::byte>> wavBytes(std::span<const float> stereo);

/// Writes the same to a file, which appears under its name only when it is complete. Errors also: the folder is missing
/// or cannot be written, the disk is full.
[[nodiscard]] Expected<void> writeWav(const std::filesystem::path& path, std::span<const float> stereo);

}  // namespace tactooth
