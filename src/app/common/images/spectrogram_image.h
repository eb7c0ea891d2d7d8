// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "geometry/util/expected.h"
#include "sound/files/spectrogram.h"

namespace tactooth {

/// Number of times in a spectrogram for the picture: one for each pixel column.
inline constexpr std::size_t kSpectrogramTimes = 1100;

/// Writes a picture (PNG) of the frequencies over time, for a sound of this length. Needs no display.
[[nodiscard]] Expected<void> writeSpectrogram(const std::filesystem::path& path, const Spectrogram& spectrogram,
                                              double seconds);

}  // namespace tactooth
