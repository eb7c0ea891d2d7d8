// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>

#include "geometry/util/expected.h"
#include "haptics/haptic_simulation.h"

namespace tactooth {

/// Writes a picture (PNG) with three plots over time: depth of the device pose behind the surface, speed of the tip,
/// force. Needs no display. Creates a QApplication for the duration of the call if there is none.
[[nodiscard]] Expected<void> writeForcePlot(const std::filesystem::path& path, std::span<const Tick> ticks);

}  // namespace tactooth
