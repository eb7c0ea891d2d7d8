// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "assessment/preparation/measured.h"
#include "session/track/session_track.h"

namespace tactooth {

/// Time in which the mirror showed the bur's tip to the eye (MirrorSight::shows), s. The time of a tick lasts until the
/// next one, 0.05 s at most. Nothing without a session, null, or where the recording does not say how the mirror was
/// held.
[[nodiscard]] Measured mirrorTime(const SessionTrack* track);

}  // namespace tactooth
