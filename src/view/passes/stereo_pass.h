// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/camera/stereo.h"
#include "view/gl/render_target.h"
#include "view/gl/shader_program.h"

namespace tactooth {

/// Combines the pictures of two eyes.
class StereoPass {
public:
    [[nodiscard]] static Expected<StereoPass> create();
    /// Draws over all of framebuffer `target`, which has `size`.
    void draw(const RenderTarget& left, const RenderTarget& right, Stereo::Mode mode, GLuint target,
              ImageSize size) const;

private:
    ShaderProgram program_;
    gl::VertexArray noVertices_;
};

}  // namespace tactooth
