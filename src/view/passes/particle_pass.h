// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/gl/shader_program.h"
#include "view/passes/frame_block.h"
#include "view/scene/particle.h"

namespace tactooth {

/// Draws drops and chips over the scene, with a depth test against it.
class ParticlePass {
public:
    [[nodiscard]] static Expected<ParticlePass> create();
    /// Draws into the bound framebuffer; the frame block of the previous pass stays bound.
    void draw(const std::vector<Particle>& particles, const PassView& view, ImageSize size) const;

private:
    ShaderProgram program_;
    gl::VertexArray array_;
    gl::Buffer buffer_;
};

}  // namespace tactooth
