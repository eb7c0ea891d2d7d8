// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/camera/camera.h"
#include "view/gl/gl_objects.h"

namespace tactooth {

/// The pixels of a picture from `low` (bottom left, OpenGL's pixel rows) up to, but not including, `high`.
struct PixelRectangle {
    Eigen::Vector2i low = Eigen::Vector2i::Zero();
    Eigen::Vector2i high = Eigen::Vector2i::Zero();

    [[nodiscard]] static PixelRectangle whole(ImageSize size) { return {{0, 0}, {size.width, size.height}}; }
    [[nodiscard]] bool empty() const { return (high.array() <= low.array()).any(); }
    [[nodiscard]] Eigen::Vector2i extent() const { return high - low; }
    [[nodiscard]] PixelRectangle within(const PixelRectangle& other) const {
        return {low.cwiseMax(other.low), high.cwiseMin(other.high)};
    }
};

/// Shrinks the clip volume of `worldToClip` to `rectangle` of the picture.
[[nodiscard]] Mat4 cropped(const Mat4& worldToClip, const PixelRectangle& rectangle, ImageSize size);

/// A framebuffer with colour, depth and stencil. Colour and depth can be read as textures afterwards. With `samples` >
/// 0 it draws to multisampled buffers, and `resolve` writes their means to the textures.
class RenderTarget {
public:
    RenderTarget() = default;
    [[nodiscard]] static Expected<RenderTarget> create(ImageSize size, int samples);

    [[nodiscard]] ImageSize size() const { return size_; }
    [[nodiscard]] int samples() const { return samples_; }
    void bindForDrawing() const;
    void resolve() const;

    [[nodiscard]] GLuint colourTexture() const { return colour_.name(); }
    [[nodiscard]] GLuint depthTexture() const { return depth_.name(); }
    /// The framebuffer with the (resolved) textures.
    [[nodiscard]] GLuint framebuffer() const { return framebuffer_.name(); }

private:
    void makeMultisampled();

    ImageSize size_;
    int samples_ = 0;
    gl::Texture colour_;
    gl::Texture depth_;
    gl::Framebuffer framebuffer_;
    gl::Renderbuffer sampledColour_;
    gl::Renderbuffer sampledDepth_;
    gl::Framebuffer sampledFramebuffer_;
};

}  // namespace tactooth
