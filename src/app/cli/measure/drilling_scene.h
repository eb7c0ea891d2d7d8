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

/// A bur at work before an eye that rests: with water and handpiece it goes down into the middle of a crown and mills
/// to and fro there, a tenth of a millimetre further in each picture. All cuts are made beforehand.
class DrillingScene {
public:
    /// `tooth`: crown up. `target`: the ideal shape of it that `ghost` shows, or nothing.
    [[nodiscard]] static Expected<DrillingScene> make(std::shared_ptr<const LayeredTooth> tooth,
                                                      const std::optional<TriangleMesh>& target, ImageSize size,
                                                      int pictures);

    /// The bur moves and its water flows, but the tooth stays whole.
    [[nodiscard]] FrameTimer::SceneSequence moving() const;
    /// The same, and each picture has a new surface to show.
    [[nodiscard]] FrameTimer::SceneSequence cutting() const;
    /// That with a second view from above, drawn anew in every fourth picture, as the window does while things move.
    [[nodiscard]] FrameTimer::SceneSequence withSecondView() const;
    /// That with the ghost of what is still to be cut.
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
