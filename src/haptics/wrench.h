// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/vec.h"

namespace tactooth {

/// A force and a torque about the tool's origin, the tip of the bur.
struct Wrench {
    Vec3 force = Vec3::Zero();   ///< N
    Vec3 torque = Vec3::Zero();  ///< N*mm
};

}  // namespace tactooth
