// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/camera/stereo.h"
#include "view/gl/render_target.h"
#include "view/gl/shader_program.h"

namespace tactooth {

/// Puts the pictures of two eyes together.
class StereoPass {
public:
    [[nodiscard]] static Expected<StereoPass> create();
    /// Over the whole of framebuffer `target`, which has `size`.
    void draw(const RenderTarget& left, const RenderTarget& right, Stereo::Mode mode, GLuint target,
              ImageSize size) const;

private:
    ShaderProgram program_;
    gl::VertexArray noVertices_;
};

}  // namespace tactooth
