// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>

#include "geometry/expected.h"

namespace tactooth {

/// Writes left and right samples by turns, at kSoundRate, as a 16-bit WAV file. Samples beyond +-1 are held there. The
/// file appears under its name only when it is complete. Errors: the folder is missing or cannot be written, the disk
/// is full.
[[nodiscard]] Expected<void> writeWav(const std::filesystem::path& path, std::span<const float> stereo);

}  // namespace tactooth
