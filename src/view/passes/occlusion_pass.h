// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/gl/render_target.h"
#include "view/gl/shader_program.h"

namespace tactooth {

/// Darkens fissures, cavities and contacts between objects: the share of the ambient light that neighbours occlude,
/// from the depth buffer, at half resolution.
class OcclusionPass {
public:
    [[nodiscard]] static Expected<OcclusionPass> create();
    /// Applies ambient occlusion to `region` of the resolved textures of `target`, drawn with `camera`. Pixels outside
    /// are neither read nor written.
    [[nodiscard]] Expected<void> apply(const RenderTarget& target, const PixelRectangle& region, const Camera& camera);

private:
    [[nodiscard]] Expected<void> fitTo(ImageSize size);

    ShaderProgram measure_;
    ShaderProgram darken_;
    ImageSize halfSize_;
    gl::Texture ambientVisibility_;
    gl::Framebuffer ambientVisibilityFramebuffer_;
    gl::Framebuffer colourFramebuffer_;  ///< the target's colour only, so that its depth can be read
    gl::VertexArray noVertices_;
};

}  // namespace tactooth
