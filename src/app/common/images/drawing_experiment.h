// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/experiments.h"

namespace tactooth {

/// Measures the time to draw a tooth, by its number of triangles, without a window.
[[nodiscard]] Expected<Experiment> measureDrawing(TestTeeth& testTeeth);

}  // namespace tactooth
