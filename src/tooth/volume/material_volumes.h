// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "tooth/model/material.h"

namespace tactooth {

/// Volumes by MaterialId, mm^3.
using MaterialVolumes = std::array<double, kMaterialCount>;

/// The sum over all materials, mm^3.
[[nodiscard]] double total(const MaterialVolumes& volumes);

}  // namespace tactooth
