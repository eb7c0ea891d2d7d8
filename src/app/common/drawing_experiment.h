// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/experiments.h"

namespace tactooth {

/// Time that a picture of a tooth takes, by its number of triangles; drawn without a window.
[[nodiscard]] Expected<Experiment> measureDrawing(TestTeeth& testTeeth);

}  // namespace tactooth
