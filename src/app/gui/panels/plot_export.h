// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/gui/panels/tick_trace.h"
#include "geometry/util/expected.h"

class QWidget;

namespace tactooth {

/// Writes the plots: a table t,depth,speed,force (s, mm, mm/s, N) if the file's name ends in .csv, a drawing of `plots`
/// if it ends in .svg or .png. Fails with one sentence.
[[nodiscard]] Expected<void> exportPlots(const TickTrace& trace, QWidget& plots, const std::filesystem::path& file);

}  // namespace tactooth
