// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "geometry/util/expected.h"
#include "sound/files/spectrogram.h"

namespace tactooth {

/// Times that a spectrogram is to have for the picture: one for each pixel across.
inline constexpr std::size_t kSpectrogramTimes = 1100;

/// Writes a picture (PNG) of the frequencies of a sound of that length over time. Needs no display.
[[nodiscard]] Expected<void> writeSpectrogram(const std::filesystem::path& path, const Spectrogram& spectrogram,
                                              double seconds);

}  // namespace tactooth
