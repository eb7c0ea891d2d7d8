// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/pose.h"

namespace tactooth {

/// Positions of the sources and of the listener, in the world frame (mm). Only directions are audible: zooming in does
/// not make the drill louder.
struct SoundPlacement {
    Vec3 source{0.0, 0.0, -300.0};      ///< the tip of the bur; by default straight ahead
    Pose listenerInWorld;               ///< the listener's +x is to the right, +y up, -z ahead, as a camera's
    Vec3 mouth{0.0, -60.0, -300.0};     ///< position of the spray
    Vec3 suction{90.0, -60.0, -300.0};  ///< the tip of the suction tube: an assistant holds it from the right
};

}  // namespace tactooth
