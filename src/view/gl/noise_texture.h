// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/gl/gl_objects.h"

namespace tactooth {

/// Makes a small periodic block of smooth noise and binds it to the current texture unit. Red, green, blue: slope of
/// the bumps; alpha: colour. The noise is the same on every machine.
[[nodiscard]] gl::Texture makeNoiseTexture();

}  // namespace tactooth
