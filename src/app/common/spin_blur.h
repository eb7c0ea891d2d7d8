// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "instruments/bur_catalogue.h"
#include "session/model/spin_envelope_mesh.h"

namespace tactooth {

/// How far the blades or grains of a bur run into each other for the eye, 0..1: 1 where one comes to the place of the
/// next within the time in which an eye takes in a picture.
[[nodiscard]] float spinBlur(double speedRpm, const BurEdge& edge);

}  // namespace tactooth
