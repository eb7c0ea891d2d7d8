// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "geometry/util/expected.h"
#include "view/scene/object_ids.h"
#include "view/scene/render_settings.h"
#include "view/scene/scene.h"

namespace tactooth {

/// Draws scenes with OpenGL 4.1 core in the current context. It must be made, used and destroyed on the thread of that
/// context, while the context is current. It keeps its data on the graphics card between frames.
class Renderer {
public:
    [[nodiscard]] static Expected<Renderer> create();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer();

    /// Draws `scene` over all of framebuffer `target` (OpenGL name; one sample per pixel, 8 bits per channel, at least
    /// `size`). Afterwards the bindings of the context are those of a new context, except that `target` stays bound.
    [[nodiscard]] Expected<void> render(const Scene& scene, unsigned target, ImageSize size,
                                        const RenderSettings& settings = kQuick);

    /// Draws which object each pixel of `scene`'s picture shows (see object_ids.h) over all of framebuffer `target`.
    [[nodiscard]] Expected<void> identify(const Scene& scene, unsigned target, ImageSize size, const MarkedBall& ball);

    /// Triangles uploaded to the graphics card for the last frame.
    [[nodiscard]] std::size_t lastUpload() const;

private:
    struct Parts;
    explicit Renderer(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace tactooth
