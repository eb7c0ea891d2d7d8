// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "session/track/session_track.h"
#include "view/camera/orbit_camera.h"

// From where the picture of a session was looked at: in a mirror another eye sees something else.

namespace tactooth {

/// The eye that first saw the mirror, tooth frame; none where the recording does not say it.
[[nodiscard]] std::optional<Vec3> firstEye(const SessionTrack& track);

/// The camera with its eye at this place. It looks at the same target.
[[nodiscard]] OrbitCamera lookingFrom(OrbitCamera camera, const Vec3& eye, ImageSize picture);

}  // namespace tactooth
