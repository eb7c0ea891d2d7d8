// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "view/scene/look.h"
#include "view/gl/shader_program.h"

namespace tactooth {

/// Hands `looks` (at most kMaxLooks) to the program in use: (linear colour, roughness), (metalness, translucency,
/// wetness, grain).
void setLooks(const ShaderProgram& program, const std::vector<Look>& looks);
/// The same for what `setLooks` leaves out.
void setOpacities(const ShaderProgram& program, const std::vector<Look>& looks);

}  // namespace tactooth
