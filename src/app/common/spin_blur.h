// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tooth/revolution_envelope.h"

namespace tactooth {

/// The body that a spinning bur seems to be, in the tool frame.
[[nodiscard]] TriangleMesh spinningShape(const RevolutionEnvelope& envelope);

/// How far the blades of a bur run into each other for the eye, 0..1: 1 where a blade comes to the place of the next
/// one within the time in which an eye takes in a picture.
[[nodiscard]] float blurOf(double speedRpm);

}  // namespace tactooth
