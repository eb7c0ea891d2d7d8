// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "instruments/bur_catalogue.h"
#include "session/model/spin_envelope_mesh.h"

namespace tactooth {

/// How much the blades or grains of a bur blur for the eye, 0..1. It is 1 if a blade reaches the place of the next one
/// within the time that the eye takes for one picture.
[[nodiscard]] float spinBlur(double speedRpm, const BurEdge& edge);

}  // namespace tactooth
