// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/gui/panels/tick_trace.h"
#include "session/model/file_writer.h"

class QWidget;

namespace tactooth {

/// Writes the plots as they are now: a table t,depth,speed,force (s, mm, mm/s, N) if the file's name ends in .csv, a
/// drawing of `plots` if it ends in .svg or .png. What it returns fails with one sentence.
[[nodiscard]] FileWriter::Write plotsExport(const TickTrace& trace, QWidget& plots, const std::filesystem::path& file);

}  // namespace tactooth
