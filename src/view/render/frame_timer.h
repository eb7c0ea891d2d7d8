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

/// What pictures cost with the making of their scenes, ms: their mean and the slowest of a hundred. Where the processor
/// draws, its time counts what the computer has to spend, whoever else uses it.
struct FrameTimes {
    double wall = 0;  ///< from the making of the scene until the last pixel, nothing else under way
    double wallP99 = 0;
    double processor = 0;  ///< of all threads of this program together
    double rate = 0;       ///< pictures a second where each is begun while the one before may still be drawn
};

/// Measures pictures that are drawn without a screen. Used on the thread that made it, which may hold no other OpenGL
/// context meanwhile.
class FrameTimer {
public:
    /// The scene for picture number i.
    using SceneSequence = std::function<Scene(int i)>;

    [[nodiscard]] static Expected<FrameTimer> create(ImageSize size);
    FrameTimer(FrameTimer&&) noexcept;
    FrameTimer& operator=(FrameTimer&&) noexcept;
    ~FrameTimer();

    /// One way to draw pictures.
    struct Candidate {
        SceneSequence sequence;
        /// As the window draws them. None: the same triangles in one colour, without light, mirror and culling, the
        /// least that drawing them can cost.
        std::optional<RenderSettings> settings;
    };

    /// `frames` pictures of each reel; two more come before them unmeasured. The candidates take turns picture by
    /// picture, so that whatever else the computer does meets all of them alike; each has a renderer of its own. Then
    /// the same pictures again in short runs for the rate: one drawn at a time would have a graphics card wait for the
    /// processor and this for the card.
    [[nodiscard]] Expected<std::vector<FrameTimes>> measureInterleaved(const std::vector<Candidate>& candidates,
                                                                       int frames);
    /// What draws, as the driver names itself.
    [[nodiscard]] std::string device() const;

private:
    struct Parts;
    explicit FrameTimer(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace tactooth
