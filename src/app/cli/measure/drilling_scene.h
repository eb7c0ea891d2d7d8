// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/common/scene_builder.h"
#include "assessment/cavity_ghost.h"
#include "assessment/exercise.h"
#include "geometry/util/expected.h"
#include "view/camera/orbit_camera.h"
#include "view/render/frame_timer.h"

namespace tactooth {

/// A bur at work in front of a fixed camera. With water and handpiece it goes down into the middle of a crown and mills
/// to and fro there, a tenth of a millimetre further in each frame. All cuts are made in advance.
class DrillingScene {
public:
    /// `tooth`: crown up. `target`: the tooth's ideal shape, which the ghost shows; may be null.
    [[nodiscard]] static Expected<DrillingScene> make(std::shared_ptr<const LayeredTooth> tooth,
                                                      const std::optional<TriangleMesh>& target, ImageSize size,
                                                      int pictures);

    /// The bur moves and its water flows, but the tooth stays uncut.
    [[nodiscard]] FrameTimer::SceneSequence moving() const;
    /// As `moving`, but each frame has a new surface.
    [[nodiscard]] FrameTimer::SceneSequence cutting() const;
    /// As `cutting`, with a second view from above. That view is redrawn in every fourth frame, as in the window while
    /// things move.
    [[nodiscard]] FrameTimer::SceneSequence withSecondView() const;
    /// As `cutting`, with the ghost of the material that is still to be cut.
    [[nodiscard]] FrameTimer::SceneSequence withGhost() const;

    [[nodiscard]] std::size_t triangles() const { return tooth_->outer()->mesh().triangles.size(); }

private:
    struct Moment {
        Pose toolInTooth;
        std::shared_ptr<const Surface> surface;
        std::vector<Particle> flying;
    };
    DrillingScene() = default;
    void play(CutModel& piece, const CuttingTool& tool, int pictures);
    [[nodiscard]] Scene sceneAt(int picture, bool cuts) const;
    [[nodiscard]] const Moment& momentOf(int picture) const;

    std::shared_ptr<const LayeredTooth> tooth_;
    std::optional<TriangleMesh> target_;
    SceneContents contents_;
    std::vector<Moment> moments_;
};

}  // namespace tactooth
