// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "view/gl/shader_program.h"
#include "view/scene/appearance.h"

namespace tactooth {

/// Sets `appearances` (at most kMaxAppearances) in the program in use: (linear colour, roughness), (metalness,
/// translucency, wetness, grain).
void setAppearances(const ShaderProgram& program, const std::vector<Appearance>& appearances);
/// Sets the opacities, which `setAppearances` leaves out.
void setOpacities(const ShaderProgram& program, const std::vector<Appearance>& appearances);

}  // namespace tactooth
