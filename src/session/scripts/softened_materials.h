// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tooth/model/material_registry.h"

namespace tactooth {

/// The built-in materials, but the same work removes `factor` times as much. So a bur keeps up with a hand that a
/// measurement leads through a tooth at a given speed.
[[nodiscard]] inline MaterialTable softenedMaterials(double factor) {
    MaterialTable materials;
    for (const MaterialId id : materials.registry().ids()) materials[id].removal *= factor;
    return materials;
}

}  // namespace tactooth
