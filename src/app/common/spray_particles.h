// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "session/simulation/spray_particle_system.h"
#include "tooth/model/material_registry.h"
#include "view/scene/particle.h"

namespace tactooth {

/// The appearance of a cloud of water and chips. Chips have the colour of the cut material, paler if water carries
/// them.
[[nodiscard]] std::vector<Particle> particlesOf(std::span<const SprayParticle> sources, const MaterialTable& materials);

}  // namespace tactooth
