// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "geometry/util/expected.h"
#include "view/scene/render_settings.h"
#include "view/scene/scene.h"

namespace tactooth {

/// Draws scenes with OpenGL 4.1 core in the context that is current; made, used and destroyed with that context
/// current, on its thread. Between pictures it keeps what is on the graphics card.
class Renderer {
public:
    [[nodiscard]] static Expected<Renderer> create();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer();

    /// Draws `scene` over the whole of framebuffer `target` (OpenGL name; one sample a pixel, 8 bits a channel, at
    /// least `size`). The bindings of the context are then those of a new context, but for `target`, which stays bound.
    [[nodiscard]] Expected<void> render(const Scene& scene, unsigned target, ImageSize size,
                                        const RenderSettings& settings = kQuick);

    /// Triangles sent to the graphics card for the last picture.
    [[nodiscard]] std::size_t lastUpload() const;

private:
    struct Parts;
    explicit Renderer(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace tactooth
