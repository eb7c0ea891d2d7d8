// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "session/io/material_file.h"

namespace tactooth {

/// The default materials, but with `factor` times as much removed by the same work: so that a bur keeps up with a hand
/// that measurements lead through a tooth at a given speed.
[[nodiscard]] inline MaterialTable softenedMaterials(double factor) {
    MaterialTable materials = defaultMaterials();
    for (std::size_t i = 0; i < kMaterialCount; ++i) materials[static_cast<MaterialId>(i)].removal *= factor;
    return materials;
}

}  // namespace tactooth
