// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/passes/cross_fade.h"

#include <utility>

#include "view/gl/messages.h"
#include "view/gl/reusable_target.h"
#include "view/gl/shader_program.h"
#include "view/gl/shaders.h"

namespace tactooth {

struct CrossFade::Parts {
    ShaderProgram program;
    gl::VertexArray noVertices;
    ReusableTarget first = {}, last = {};

    static Expected<void> keep(GLuint shown, ImageSize size, ReusableTarget& in);
};

Expected<void> CrossFade::Parts::keep(GLuint shown, ImageSize size, ReusableTarget& in) {
    const auto kept = in.fit(size, 0);
    if (!kept) return Unexpected{kept.error()};
    glBindFramebuffer(GL_READ_FRAMEBUFFER, shown);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, (*kept)->framebuffer());
    glDisable(GL_SCISSOR_TEST);
    glBlitFramebuffer(0, 0, size.width, size.height, 0, 0, size.width, size.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, shown);
    return gl::checkErrors(msg::kDrawingPicture);
}

Expected<CrossFade> CrossFade::create() {
    auto program = ShaderProgram::create("cross-fade", "", {shaders::kWholePictureVert}, {shaders::kCrossFadeFrag});
    if (!program) return Unexpected{program.error()};
    return CrossFade(std::unique_ptr<Parts>(new Parts{std::move(*program), gl::VertexArray::make()}));
}

CrossFade::CrossFade(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
CrossFade::CrossFade(CrossFade&&) noexcept = default;
CrossFade& CrossFade::operator=(CrossFade&&) noexcept = default;
CrossFade::~CrossFade() = default;

Expected<void> CrossFade::keepFirst(unsigned shown, ImageSize size) { return Parts::keep(shown, size, parts_->first); }

Expected<void> CrossFade::keepLast(unsigned shown) {
    return Parts::keep(shown, parts_->first.target().size(), parts_->last);
}

void CrossFade::draw(unsigned target, double share) const {
    const RenderTarget &first = parts_->first.target(), &last = parts_->last.target();
    const ImageSize size = last.size();
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glViewport(0, 0, size.width, size.height);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_STENCIL_TEST);
    const ShaderProgram& program = parts_->program;
    program.use();
    program.set("firstPicture", 0);
    program.set("lastPicture", 1);
    program.set("share", static_cast<float>(share));
    gl::bindTexture(1, GL_TEXTURE_2D, last.colourTexture());
    gl::bindTexture(0, GL_TEXTURE_2D, first.colourTexture());
    glBindVertexArray(parts_->noVertices.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glUseProgram(0);
    gl::bindTexture(1, GL_TEXTURE_2D, 0);
    gl::bindTexture(0, GL_TEXTURE_2D, 0);
}

}  // namespace tactooth
