// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/gl/render_target.h"

#include <algorithm>

#include "view/gl/messages.h"

namespace tactooth {

Mat4 cropped(const Mat4& worldToClip, const PixelRectangle& rectangle, ImageSize size) {
    const Eigen::Array2d whole(size.width, size.height);
    const Eigen::Array2d low = 2 * rectangle.low.cast<double>().array() / whole - 1;
    const Eigen::Array2d high = 2 * rectangle.high.cast<double>().array() / whole - 1;
    Mat4 crop = Mat4::Identity();
    for (int axis = 0; axis < 2; ++axis) {
        crop(axis, axis) = 2 / (high[axis] - low[axis]);
        crop(axis, 3) = -(high[axis] + low[axis]) / (high[axis] - low[axis]);
    }
    return crop * worldToClip;
}

Expected<RenderTarget> RenderTarget::create(ImageSize size, int samples) {
    GLint mostSamples = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &mostSamples);
    RenderTarget target;
    target.size_ = size;
    target.samples_ = std::min(samples, mostSamples);
    target.colour_ = gl::Texture::make();
    gl::allocateTexture(target.colour_, GL_RGBA8, size.width, size.height, GL_NEAREST);
    target.depth_ = gl::Texture::make();
    gl::allocateTexture(target.depth_, GL_DEPTH24_STENCIL8, size.width, size.height, GL_NEAREST);
    target.framebuffer_ = gl::Framebuffer::make();
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer_.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.colour_.name(), 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, target.depth_.name(), 0);
    if (target.samples_ > 0) target.makeMultisampled();
    const auto problem = gl::checkErrors({msg::kMakingPictureOf, size.width, size.height});
    if (!problem) return Unexpected{problem.error()};
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        return unexpected(msg::kPictureRefused, size.width, size.height);
    }
    return target;
}

void RenderTarget::makeMultisampled() {
    sampledColour_ = gl::Renderbuffer::make();
    glBindRenderbuffer(GL_RENDERBUFFER, sampledColour_.name());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, GL_RGBA8, size_.width, size_.height);
    sampledDepth_ = gl::Renderbuffer::make();
    glBindRenderbuffer(GL_RENDERBUFFER, sampledDepth_.name());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, GL_DEPTH24_STENCIL8, size_.width, size_.height);
    sampledFramebuffer_ = gl::Framebuffer::make();
    glBindFramebuffer(GL_FRAMEBUFFER, sampledFramebuffer_.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, sampledColour_.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, sampledDepth_.name());
}

void RenderTarget::bindForDrawing() const {
    glBindFramebuffer(GL_FRAMEBUFFER, samples_ > 0 ? sampledFramebuffer_.name() : framebuffer_.name());
    glViewport(0, 0, size_.width, size_.height);
}

void RenderTarget::resolve() const {
    if (samples_ == 0) return;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, sampledFramebuffer_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.name());
    glBlitFramebuffer(0, 0, size_.width, size_.height, 0, 0, size_.width, size_.height,
                      GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
}

}  // namespace tactooth
