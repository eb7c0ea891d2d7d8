// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/passes/antialiasing_pass.h"

namespace tactooth {

void AntialiasingPass::apply(const RenderTarget& target) {
    const auto [width, height] = target.size();
    pixels_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, target.framebuffer());
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels_.data());
    const ChangedRows rows = smoothEdges(pixels_, target.size());
    if (rows.first == rows.end) return;
    const Rgba* const first = pixels_.data() + static_cast<std::ptrdiff_t>(rows.first) * width;
    gl::bindTexture(0, GL_TEXTURE_2D, target.colourTexture());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, rows.first, width, rows.end - rows.first, GL_RGBA, GL_UNSIGNED_BYTE, first);
}

}  // namespace tactooth
