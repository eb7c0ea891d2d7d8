// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/gl/gl_objects.h"

namespace tactooth {

/// A small repeating block of smooth noise (red, green, blue: slope of the bumps; alpha: colour), the same on every
/// machine, bound to the current texture unit.
[[nodiscard]] gl::Texture makeNoiseTexture();

}  // namespace tactooth
