// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "collision/bvh/surface.h"
#include "tooth/model/material.h"

namespace tactooth {

inline constexpr double kStandardBurRadius = 0.7;  // mm: the head of bur 4
inline constexpr double kGrooveDepth = 1.0;        // mm, of the V
inline constexpr double kGrooveRest = 0.71;  // mm that the bur's tip goes into the V: depth - (sqrt(2) - 1) * radius
inline constexpr double kSlotDepth = 1.0;    // mm

/// Prisms along y, 12 mm wide, of one material, with the profiles of details of a tooth: a plane at z = 0; a roof of 90
/// degrees with its edge at x = 0, z = 0; a V of 90 degrees; a slot hardly wider than the standard bur.
[[nodiscard]] std::shared_ptr<const Surface> flatSpecimen(MaterialId material);
[[nodiscard]] std::shared_ptr<const Surface> ridgeSpecimen(MaterialId material);
[[nodiscard]] std::shared_ptr<const Surface> grooveSpecimen(MaterialId material);
[[nodiscard]] std::shared_ptr<const Surface> slotSpecimen(MaterialId material);

}  // namespace tactooth
