// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/passes/occlusion_pass.h"

#include <cmath>

#include "view/gl/messages.h"
#include "view/gl/shaders.h"

namespace tactooth {

namespace {

constexpr float kReach = 1.6F;  ///< mm: half the width of the central fossa of a molar

void scissor(const PixelRectangle& region) {
    glScissor(region.low.x(), region.low.y(), region.extent().x(), region.extent().y());
}

/// The first and the last pixel of `region`; the shaders clamp to them.
Eigen::Vector4f corners(const PixelRectangle& region) {
    Eigen::Vector4i corners;
    corners << region.low, region.high.array() - 1;
    return corners.cast<float>();
}

}  // namespace

Expected<OcclusionPass> OcclusionPass::create() {
    OcclusionPass pass;
    auto measure = ShaderProgram::create("occlusion", "", {shaders::kWholePictureVert}, {shaders::kOcclusionFrag});
    if (!measure) return Unexpected{measure.error()};
    auto darken =
        ShaderProgram::create("occlusion on picture", "", {shaders::kWholePictureVert}, {shaders::kOcclusionApplyFrag});
    if (!darken) return Unexpected{darken.error()};
    pass.measure_ = std::move(*measure);
    pass.darken_ = std::move(*darken);
    pass.ambientVisibilityFramebuffer_ = gl::Framebuffer::make();
    pass.colourFramebuffer_ = gl::Framebuffer::make();
    pass.noVertices_ = gl::VertexArray::make();
    return pass;
}

Expected<void> OcclusionPass::fitTo(ImageSize size) {
    const ImageSize half{(size.width + 1) / 2, (size.height + 1) / 2};
    if (half == halfSize_) return {};
    halfSize_ = half;
    ambientVisibility_ = gl::Texture::make();
    gl::allocateTexture(ambientVisibility_, GL_R8, half.width, half.height, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, ambientVisibilityFramebuffer_.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, ambientVisibility_.name(), 0);
    return gl::checkErrors(msg::kPreparingOcclusion);
}

Expected<void> OcclusionPass::apply(const RenderTarget& target, const PixelRectangle& region, const Camera& camera) {
    const ImageSize size = target.size();
    if (auto problem = fitTo(size); !problem) return problem;
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glBindVertexArray(noVertices_.name());
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, ambientVisibility_.name());
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, target.depthTexture());

    glBindFramebuffer(GL_FRAMEBUFFER, ambientVisibilityFramebuffer_.name());
    glViewport(0, 0, halfSize_.width, halfSize_.height);
    glEnable(GL_SCISSOR_TEST);
    scissor({region.low / 2, (region.high + Eigen::Vector2i::Ones()) / 2});
    measure_.use();
    measure_.set("region", corners(region));
    measure_.set("depthPicture", 0);
    measure_.set("clipToView", Mat4(projectionMatrix(camera, size.aspect()).inverse()));
    measure_.set("pixelsPerRadian", static_cast<float>(size.height / (2 * std::tan(camera.fieldOfView / 2))));
    measure_.set("reach", kReach);
    glDrawArrays(GL_TRIANGLES, 0, 3);

    glBindFramebuffer(GL_FRAMEBUFFER, colourFramebuffer_.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.colourTexture(), 0);
    glViewport(0, 0, size.width, size.height);
    scissor(region);
    darken_.use();
    darken_.set("region", corners(region));
    darken_.set("depthPicture", 0);
    darken_.set("ambientVisibilityMap", 1);
    darken_.set("depthRange",
                Eigen::Vector4f(static_cast<float>(camera.nearDistance), static_cast<float>(camera.farDistance), 0, 0));
    glEnable(GL_BLEND);
    glBlendFunc(GL_ZERO, GL_SRC_COLOR);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    return {};
}

}  // namespace tactooth
