// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/util/vec.h"

namespace tactooth {

/// A place where nothing may be cut: what lies below a closed outline, seen along a direction.
struct ForbiddenZone {
    std::vector<Vec3> corners;  ///< on the surface, the first not repeated, mm
    Vec3 outward;               ///< out of the tooth, unit

    bool operator==(const ForbiddenZone&) const = default;
};

}  // namespace tactooth
