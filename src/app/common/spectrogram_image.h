// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>

#include "geometry/expected.h"

namespace tactooth {

/// Writes a picture (PNG) of the frequencies of a sound over time: left and right samples by turns, at kSoundRate.
/// Needs no display.
[[nodiscard]] Expected<void> writeSpectrogram(const std::filesystem::path& path, std::span<const float> stereo);

}  // namespace tactooth
