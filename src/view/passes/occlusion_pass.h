// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/gl/render_target.h"
#include "view/gl/shader_program.h"

namespace tactooth {

/// Darkens fissures, cavities and where things touch: the share of surrounding light that neighbours hide, from the
/// depth picture, at half resolution.
class OcclusionPass {
public:
    [[nodiscard]] static Expected<OcclusionPass> create();
    /// Applies to `region` of the resolved textures of `target`, drawn with `camera`; the rest is neither read nor
    /// written.
    [[nodiscard]] Expected<void> apply(const RenderTarget& target, const PixelRectangle& region, const Camera& camera);

private:
    [[nodiscard]] Expected<void> fitTo(ImageSize size);

    ShaderProgram measure_;
    ShaderProgram darken_;
    ImageSize halfSize_;
    gl::Texture ambientVisibility_;
    gl::Framebuffer ambientVisibilityFramebuffer_;
    gl::Framebuffer colourFramebuffer_;  ///< the target's colour alone, so that its depth can be read
    gl::VertexArray noVertices_;
};

}  // namespace tactooth
