// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/gui/panels/tick_trace.h"
#include "session/track/session_track.h"

namespace tactooth {

/// The seconds before a moment of a recording as a plot shows them. The track has the moment.
[[nodiscard]] TickTrace traceBefore(const SessionTrack& track, std::uint64_t moment);

}  // namespace tactooth
