// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/camera/stereo.h"

#include <cmath>

namespace tactooth {

std::array<Camera, 2> stereoCameras(const Camera& camera, const Stereo& stereo) {
    std::array<Camera, 2> eyes = {camera, camera};
    const double halfHeightAtFocus = stereo.focus * std::tan(camera.fieldOfView / 2);
    for (std::size_t i = 0; i < eyes.size(); ++i) {
        const double aside = (i == 0 ? -0.5 : 0.5) * stereo.separation;
        eyes[i].cameraInWorld.position += camera.cameraInWorld.rotation * Vec3(aside, 0, 0);
        eyes[i].lensShift -= aside / halfHeightAtFocus;
    }
    return eyes;
}

}  // namespace tactooth
