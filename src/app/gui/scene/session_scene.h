// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/common/scene_builder.h"
#include "session/model/session_model.h"
#include "view/camera/orbit_camera.h"

namespace tactooth {

/// What a picture of the session shows; the camera is left out.
[[nodiscard]] SceneContents sceneContents(const SessionModel& model, bool withTurbine, bool withMirror);

/// From where a dentist sees the tooth of a mouth (chairView); any other tooth from buccal and above.
[[nodiscard]] OrbitCamera::Direction defaultView(const SessionModel& model);

}  // namespace tactooth
