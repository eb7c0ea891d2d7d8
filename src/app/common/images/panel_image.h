// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/experiment.h"

namespace tactooth {

/// Writes the panels of the experiment as one picture (PNG), side by side in its number of columns. Needs no display.
[[nodiscard]] Expected<void> writePanels(const Experiment& experiment, const std::filesystem::path& path);

}  // namespace tactooth
