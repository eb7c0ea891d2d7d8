// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <stop_token>

#include "session/recording/session_recording.h"
#include "session/track/session_track.h"

namespace tactooth {

/// A track without ticks for a recording, with the tooth before its first event and with the mirror. `model`: that
/// tooth, from SessionRecording::makeModel. Reads all events once, to know the length. Fails with one sentence if the
/// recording is damaged; makeTrack says it where only the mirror is.
[[nodiscard]] Expected<std::shared_ptr<SessionTrack>> emptyTrack(const SessionRecording& recording,
                                                                 const CutModel& model);

/// Simulates the recording once, as fast as this machine can, and fills the track with what happens. `model` is that of
/// emptyTrack. Ends early on request; the track is finished in any case.
void makeTrack(const SessionRecording& recording, std::shared_ptr<CutModel> model, SessionTrack& track,
               const std::stop_token& stop = {});

}  // namespace tactooth
