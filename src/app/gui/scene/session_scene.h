// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/common/scene_builder.h"
#include "session/model/session_model.h"
#include "view/camera/orbit_camera.h"

namespace tactooth {

/// What a picture of the session shows; the camera is left out.
[[nodiscard]] SceneContents sceneContents(const SessionModel& model, bool withTurbine, bool withMirror);

/// The mouth mirror as the mouse and a device hold it. Needs a runner.
[[nodiscard]] Pose mirrorPose(const SessionModel& model);

/// The glass of the mouth mirror where the picture shows it; none until the instruments are made.
[[nodiscard]] std::optional<MirrorDisc> mirrorGlass(const SessionModel& model);

/// From where a dentist sees the tooth (chairViewOf).
[[nodiscard]] OrbitCamera::Direction defaultView(const SessionModel& model);

}  // namespace tactooth
