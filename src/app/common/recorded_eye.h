// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "view/camera/orbit_camera.h"

namespace tactooth {

/// The camera with its eye at this place, as that of a recorded session was (firstEye). It looks at the same target.
[[nodiscard]] OrbitCamera lookingFrom(OrbitCamera camera, const Vec3& eye, ImageSize picture);

}  // namespace tactooth
