// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/util/expected.h"
#include "view/scene/render_settings.h"
#include "view/scene/scene.h"

namespace tactooth {

/// The cost of frames, ms, including the making of their scenes: the mean and the slowest of a hundred. If the
/// processor draws, its time is the cost to the computer, whatever other programs use it.
struct FrameTimes {
    double wall = 0;  ///< from the making of the scene to the last pixel, with nothing else in progress
    double wallP99 = 0;
    double processor = 0;  ///< of all threads of this program together
    double rate = 0;       ///< frames a second, if each one starts while the one before may still be drawn
};

/// Measures frames that are drawn without a screen. Use it on the thread that made it; that thread must not hold
/// another OpenGL context meanwhile.
class FrameTimer {
public:
    /// Returns the scene of frame number i.
    using SceneSequence = std::function<Scene(int i)>;

    [[nodiscard]] static Expected<FrameTimer> create(ImageSize size);
    FrameTimer(FrameTimer&&) noexcept;
    FrameTimer& operator=(FrameTimer&&) noexcept;
    ~FrameTimer();

    /// One way to draw the frames.
    struct Candidate {
        SceneSequence sequence;
        /// As the window draws them. If empty: the same triangles in one colour, without light, mirror and culling.
        /// That is the lowest possible cost of drawing them.
        std::optional<RenderSettings> settings;
    };

    /// Measures `frames` frames of each candidate, after two unmeasured ones. The candidates take turns frame by frame,
    /// so that other work of the computer affects all of them alike; each has its own renderer. Then the same frames
    /// are drawn again in short runs for the rate. With single frames, the graphics card and the processor would wait
    /// for each other.
    [[nodiscard]] Expected<std::vector<FrameTimes>> measureInterleaved(const std::vector<Candidate>& candidates,
                                                                       int frames);
    /// The driver's name for the renderer.
    [[nodiscard]] std::string device() const;

private:
    struct Parts;
    explicit FrameTimer(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace tactooth
