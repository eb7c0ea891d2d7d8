// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/passes/particle_pass.h"

#include "view/gl/shaders.h"

namespace tactooth {

namespace {

static_assert(sizeof(Particle) == 11 * sizeof(float));  // the layout that the shader reads

void describe(GLuint place, GLint numbers, std::size_t offset) {
    glEnableVertexAttribArray(place);
    glVertexAttribPointer(place, numbers, GL_FLOAT, GL_FALSE, sizeof(Particle), reinterpret_cast<const void*>(offset));
}

}  // namespace

Expected<ParticlePass> ParticlePass::create() {
    ParticlePass pass;
    auto program =
        ShaderProgram::create("particles", "", {shaders::kFrame, shaders::kParticleVert}, {shaders::kParticleFrag});
    if (!program) return Unexpected{program.error()};
    pass.program_ = std::move(*program);
    pass.array_ = gl::VertexArray::make();
    pass.buffer_ = gl::Buffer::make();
    glBindVertexArray(pass.array_.name());
    glBindBuffer(GL_ARRAY_BUFFER, pass.buffer_.name());
    describe(0, 4, 0);
    describe(1, 4, 4 * sizeof(float));
    describe(2, 3, 8 * sizeof(float));
    glBindVertexArray(0);
    return pass;
}

void ParticlePass::draw(const std::vector<Particle>& particles, const PassView& view, ImageSize size) const {
    if (particles.empty()) return;
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(particles.size() * sizeof(Particle)), particles.data(),
                 GL_STREAM_DRAW);
    program_.use();
    program_.set("pixelsPerRadian", static_cast<float>(0.5 * size.height * view.viewToClip(1, 1)));
    glEnable(GL_PROGRAM_POINT_SIZE);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    glBindVertexArray(array_.name());
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(particles.size()));
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glDisable(GL_PROGRAM_POINT_SIZE);
}

}  // namespace tactooth
