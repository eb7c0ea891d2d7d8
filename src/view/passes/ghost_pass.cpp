// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/passes/ghost_pass.h"

#include <array>

#include "view/gl/shaders.h"
#include "view/passes/appearance_uniforms.h"
#include "view/scene/ghost_scale.h"

namespace tactooth {
namespace {

// Not used by SolidPass, so that its textures stay bound.
constexpr int kShellUnit = 5;
constexpr int kColourUnit = 6;
constexpr int kDepthUnit = 7;

// Where the near layer is visible, the eye looks through tooth that stays: all that lies behind is dimmed.
constexpr GLenum kFarLayer = GL_BACK, kNearLayer = GL_FRONT;  // the faces that are culled
constexpr float kFarCover = 1.0F, kNearCover = 0.40F;         // factors on the appearance's opacity
constexpr float kBehindNear = 0.30F;                          // factor on the opacity of the far layer

void setScale(const ShaderProgram& program) {
    std::array<Eigen::Vector4f, kGhostColours.size()> colours;
    for (std::size_t i = 0; i < colours.size(); ++i) colours[i] << linearColour(kGhostColours[i]), 1;
    program.setAll("stepColours", colours.data(), static_cast<int>(colours.size()));
    program.set("stepSize", static_cast<float>(kGhostStep));
}

void setHiddenOpacities(const ShaderProgram& program, const std::vector<Appearance>& appearances) {
    std::array<float, kMaxAppearances> packed{};
    for (std::size_t i = 0; i < appearances.size(); ++i) packed[i] = appearances[i].hiddenOpacity;
    program.setAll("hiddenOpacities", packed.data(), static_cast<int>(appearances.size()));
}

}  // namespace

PixelRectangle ghostPixels(const std::vector<Drawable>& ghosts, const PassView& view, ImageSize size) {
    Eigen::AlignedBox2d covered;
    for (const Drawable& ghost : ghosts) {
        const Mat4 toClip = view.worldToClip() * ghost.objectToWorld;
        const Box3 box = ghost.buffers->box();
        for (int i = 0; i < 8; ++i) {
            const Eigen::Vector4d corner = toClip * box.corner(static_cast<Box3::CornerType>(i)).homogeneous();
            if (corner.w() <= 0) return PixelRectangle::whole(size);  // at the eye's plane or behind it
            covered.extend(Vec2(corner.head<2>() / corner.w()));
        }
    }
    if (covered.isEmpty()) return {};
    const Eigen::Array2d half = Eigen::Array2d(size.width, size.height) / 2;
    const auto pixels = [&](const Vec2& place) -> Eigen::Array2d {
        return (half * (place.array() + 1)).max(0).min(2 * half);
    };
    return {pixels(covered.min()).floor().matrix().cast<int>(), pixels(covered.max()).ceil().matrix().cast<int>()};
}

Expected<GhostPass> GhostPass::create() {
    GhostPass pass;
    auto body = ShaderProgram::create("ghost",
                                      "#define MAX_APPEARANCES " + std::to_string(kMaxAppearances) +
                                          "\n#define RICH 1\n#define GHOST_STEPS " +
                                          std::to_string(kGhostColours.size()) + "\n",
                                      {shaders::kFrame, shaders::kNoise, shaders::kSolidVert},
                                      {shaders::kFrame, shaders::kColour, shaders::kGhostFrag});
    if (!body) return Unexpected{body.error()};
    auto compose =
        ShaderProgram::create("ghost on picture", "", {shaders::kWholePictureVert}, {shaders::kGhostComposeFrag});
    if (!compose) return Unexpected{compose.error()};
    pass.body_ = std::move(*body);
    pass.compose_ = std::move(*compose);
    pass.frameBuffer_ = gl::Buffer::make();
    pass.noVertices_ = gl::VertexArray::make();
    return pass;
}

void GhostPass::draw(const SolidInputs& inputs, const RenderTarget& into) const {
    glBindBuffer(GL_UNIFORM_BUFFER, frameBuffer_.name());
    glBufferData(GL_UNIFORM_BUFFER, sizeof inputs.frame, &inputs.frame, GL_STREAM_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, kFrameBinding, frameBuffer_.name());
    into.bindForDrawing();
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl::bindTexture(kShellUnit, GL_TEXTURE_2D, inputs.shell->depthTexture());
    body_.use();
    body_.set("shellDepth", kShellUnit);
    setScale(body_);
    glFrontFace(inputs.view.mirrored ? GL_CW : GL_CCW);
    glEnable(GL_CULL_FACE);
    glEnable(GL_CLIP_DISTANCE1);
    glBlendColor(kBehindNear, kBehindNear, kBehindNear, kBehindNear);
    for (const Drawable& drawable : inputs.ghosts) {
        drawLayer(inputs, drawable, kFarLayer, kFarCover);
        drawLayer(inputs, drawable, kNearLayer, kNearCover);
    }
    glCullFace(GL_BACK);
    glDisable(GL_CLIP_DISTANCE1);
    glFrontFace(GL_CCW);
    into.resolve();
    gl::bindTexture(kShellUnit, GL_TEXTURE_2D, 0);
}

/// Draws only the nearest faces of the layer, so that their order does not matter. Behind the far layer of the first
/// ghost there is nothing to blend with. For all other layers the depth is drawn first, then the colour.
void GhostPass::drawLayer(const SolidInputs& inputs, const Drawable& drawable, GLenum culled, float cover) const {
    setAppearances(body_, drawable.object->appearances);
    setOpacities(body_, drawable.object->appearances);
    setHiddenOpacities(body_, drawable.object->appearances);
    body_.set("appearanceCount", static_cast<int>(drawable.object->appearances.size()));
    body_.set("objectToWorld", drawable.objectToWorld);
    body_.set("sectioned", 1);
    body_.set("cover", cover);
    body_.set("isNear", culled == kNearLayer ? 1 : 0);
    glBlendFunc(GL_ONE, culled == kFarLayer ? GL_ONE_MINUS_SRC_ALPHA : GL_CONSTANT_COLOR);
    glCullFace(culled);
    const ClusterCuller culler = cullerFor(inputs, drawable, false, inputs.lodTolerance);
    if (culled == kFarLayer && &drawable == &inputs.ghosts.front()) return drawable.buffers->draw(culler);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    drawable.buffers->draw(culler);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_BLEND);
    drawable.buffers->draw(culler);
    glDisable(GL_BLEND);
    glDepthFunc(GL_LESS);
}

/// Where the tooth is visible, draws the ghosts regardless of depth. Elsewhere, draws only ghost parts that are in
/// front of the scene.
void GhostPass::compose(const RenderTarget& drawn) const {
    gl::bindTexture(kColourUnit, GL_TEXTURE_2D, drawn.colourTexture());
    gl::bindTexture(kDepthUnit, GL_TEXTURE_2D, drawn.depthTexture());
    compose_.use();
    compose_.set("ghostColour", kColourUnit);
    compose_.set("ghostDepth", kDepthUnit);
    glDisable(GL_CULL_FACE);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glEnable(GL_STENCIL_TEST);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    glBindVertexArray(noVertices_.name());
    for (const bool throughTooth : {true, false}) {
        glStencilFunc(GL_EQUAL, throughTooth ? kStencilSeenThrough : 0, kStencilSeenThrough);
        glDepthFunc(throughTooth ? GL_ALWAYS : GL_LESS);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
    glDisable(GL_STENCIL_TEST);
    glDepthFunc(GL_LESS);
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
    gl::bindTexture(kColourUnit, GL_TEXTURE_2D, 0);
    gl::bindTexture(kDepthUnit, GL_TEXTURE_2D, 0);
}

}  // namespace tactooth
