// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/drawable.h"
#include "view/frame_block.h"
#include "view/render_settings.h"
#include "view/shader_program.h"
#include "view/shadow_map.h"

namespace tactooth {

/// Draws the background and the lit objects into whatever framebuffer is bound.
class SolidPass {
public:
    [[nodiscard]] static Expected<SolidPass> create();

    /// `cullMatrix` sees at most what the pass shows; runs of triangles outside it are skipped.
    void draw(const std::vector<Drawable>& drawables, const PassView& view, const FrameBlock& frame,
              const Mat4& cullMatrix, Shadows shadows, const ShadowMap& shadowMap) const;

private:
    void drawObject(const ShaderProgram& program, const Drawable& drawable, const PassView& view,
                    const Mat4& cullMatrix) const;

    std::array<ShaderProgram, 3> programs_;  ///< by Shadows
    ShaderProgram background_;
    gl::Texture grain_;
    gl::Buffer frameBuffer_;
    gl::VertexArray noVertices_;
};

/// sRGB to linear light, channel by channel.
[[nodiscard]] Vec3f linearColour(const Vec3f& srgb);

}  // namespace tactooth
