// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/passes/stereo_pass.h"

#include "view/gl/shaders.h"

namespace tactooth {

Expected<StereoPass> StereoPass::create() {
    StereoPass pass;
    auto program = ShaderProgram::create("stereo", "", {shaders::kWholePictureVert}, {shaders::kStereoFrag});
    if (!program) return Unexpected{program.error()};
    pass.program_ = std::move(*program);
    pass.noVertices_ = gl::VertexArray::make();
    return pass;
}

void StereoPass::draw(const RenderTarget& left, const RenderTarget& right, Stereo::Mode mode, GLuint target,
                      ImageSize size) const {
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glViewport(0, 0, size.width, size.height);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    program_.use();
    program_.set("leftPicture", 0);
    program_.set("rightPicture", 1);
    program_.set("anaglyph", mode == Stereo::Mode::Anaglyph ? 1 : 0);
    program_.set("targetSize", Eigen::Vector4f(static_cast<float>(size.width), static_cast<float>(size.height), 0, 0));
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, right.colourTexture());
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, left.colourTexture());
    glBindVertexArray(noVertices_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace tactooth
