// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/render/offscreen.h"

#include <algorithm>

#include "view/gl/egl_context.h"
#include "view/gl/gl_objects.h"
#include "view/gl/messages.h"

namespace tactooth {

namespace {

/// OpenGL's rows go from bottom to top, those of an Image from top to bottom.
void flipRows(Image& image) {
    const auto row = [&](int y) { return image.pixels.begin() + std::ptrdiff_t{y} * image.size.width; };
    for (int y = 0; y < image.size.height / 2; ++y) {
        std::swap_ranges(row(y), row(y + 1), row(image.size.height - 1 - y));
    }
}

}  // namespace

struct OffscreenRenderer::Parts {
    EglContext context;  // first member: it must exist while the others are destroyed
    Renderer renderer;
    gl::Texture colour;
    gl::Framebuffer framebuffer;
    ImageSize size;

    Expected<void> fitTo(ImageSize wanted);
    /// The picture that `drawInto` draws into the framebuffer of this name.
    template <class DrawInto>
    Expected<Image> draw(ImageSize wanted, const DrawInto& drawInto);
};

Expected<void> OffscreenRenderer::Parts::fitTo(ImageSize wanted) {
    if (size == wanted) return {};
    gl::allocateTexture(colour, GL_RGBA8, wanted.width, wanted.height, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour.name(), 0);
    size = wanted;
    return gl::checkErrors(msg::kMakingPicture);
}

template <class DrawInto>
Expected<Image> OffscreenRenderer::Parts::draw(ImageSize wanted, const DrawInto& drawInto) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (std::min(wanted.width, wanted.height) <= 0 || std::max(wanted.width, wanted.height) > largest) {
        return unexpected(msg::kPictureSize, wanted.width, wanted.height, largest);
    }
    if (auto done = fitTo(wanted); !done) return Unexpected{done.error()};
    if (auto done = drawInto(framebuffer.name()); !done) return Unexpected{done.error()};
    Image image{wanted, {}};
    image.pixels.resize(static_cast<std::size_t>(wanted.width) * static_cast<std::size_t>(wanted.height));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, wanted.width, wanted.height, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
    flipRows(image);
    if (auto done = gl::checkErrors(msg::kReadingPicture); !done) return Unexpected{done.error()};
    return image;
}

Expected<OffscreenRenderer> OffscreenRenderer::create() {
    auto context = EglContext::create();
    if (!context) return Unexpected{context.error()};
    auto renderer = Renderer::create();
    if (!renderer) return Unexpected{renderer.error()};
    return OffscreenRenderer(std::unique_ptr<Parts>(
        new Parts{std::move(*context), std::move(*renderer), gl::Texture::make(), gl::Framebuffer::make(), {}}));
}

OffscreenRenderer::OffscreenRenderer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
OffscreenRenderer::OffscreenRenderer(OffscreenRenderer&&) noexcept = default;
OffscreenRenderer& OffscreenRenderer::operator=(OffscreenRenderer&&) noexcept = default;
OffscreenRenderer::~OffscreenRenderer() = default;

std::string OffscreenRenderer::device() const { return rendererName(); }
std::size_t OffscreenRenderer::lastUpload() const { return parts_->renderer.lastUpload(); }

Expected<Image> OffscreenRenderer::render(const Scene& scene, ImageSize size, const RenderSettings& settings) {
    return parts_->draw(size, [&](GLuint target) { return parts_->renderer.render(scene, target, size, settings); });
}

Expected<Image> OffscreenRenderer::identify(const Scene& scene, ImageSize size, const MarkedBall& ball) {
    return parts_->draw(size, [&](GLuint target) { return parts_->renderer.identify(scene, target, size, ball); });
}

}  // namespace tactooth
