// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/common/replay_scene.h"
#include "session/model/instrument_set.h"
#include "session/recording/session_replay.h"
#include "view/camera/orbit_camera.h"
#include "view/render/offscreen.h"

namespace tactooth {

/// Draws moments of a replay: the tooth, all around it, the instrument and the mouth mirror.
class ReplayPictures {
public:
    /// `view`: as for `tactooth render`; none: the eye that first saw the mirror, else as a dentist looks. `model`: of
    /// the replay. Fails with one sentence if the view is unknown, if the recording is damaged, or if this machine
    /// cannot draw.
    [[nodiscard]] static Expected<ReplayPictures> create(const std::optional<std::string>& view, ImageSize size,
                                                         const SessionRecording& recording, const CutModel& model);

    /// `tick` is the newest tick of the replay; `time`: since the session began, s.
    [[nodiscard]] Expected<Image> draw(const SessionReplay& replay, const Tick& tick, double time);

private:
    ReplayPictures(OffscreenRenderer renderer, const OrbitCamera& camera, ImageSize size, const CutModel& model,
                   std::vector<MirrorMoment> mirror);

    OffscreenRenderer renderer_;
    OrbitCamera camera_;
    ImageSize size_;
    std::vector<ShownBody> around_;
    HandpieceMeshes handpieces_;
    std::shared_ptr<const ToolShape> shape_;  // of `bur_`
    ReplayBur bur_;
    std::vector<MirrorMoment> held_;  // in the order of their ticks
    ReplayMirror mirror_;
};

}  // namespace tactooth
