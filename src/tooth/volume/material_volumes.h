// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "tooth/model/material.h"

namespace tactooth {

/// Volumes by MaterialId, mm^3; zero where the registry of the tooth has no material.
using MaterialVolumes = std::array<double, kMaxMaterials>;

/// The sum over all materials, mm^3.
[[nodiscard]] double total(const MaterialVolumes& volumes);

}  // namespace tactooth
