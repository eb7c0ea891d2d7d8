// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "geometry/util/vec.h"

namespace tactooth {

/// The centre of a dental arch, from a point of each crown (mm, one frame): the centre of the circle through them
/// (least squares after Kasa, 1976) in their common plane. None for fewer than three teeth, or where they are on a
/// line.
[[nodiscard]] std::optional<Vec3> archCentre(std::span<const Vec3> crowns);

}  // namespace tactooth
