// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "instruments/mouth/neck_curve.h"
#include "instruments/mouth/zoned_mesh.h"

namespace tactooth {

/// The tongue, as it lies behind and below the crowns of the lower teeth while the mouth is open, and the floor of the
/// mouth around it. Frame of the lower jaw (the mouth frame with the mouth closed). `heldAsideAt`: length along the
/// curve where a mirror holds the tongue away from the teeth.
[[nodiscard]] ZonedMesh makeTongue(const NeckCurve& lower, std::optional<double> heldAsideAt);

}  // namespace tactooth
