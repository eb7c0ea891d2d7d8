// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/solid_pass.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "view/grain.h"
#include "view/shaders.h"

namespace tactooth {

namespace {

constexpr int kGrainUnit = 0;
constexpr int kShadowUnit = 1;
constexpr int kBackgroundVertices = 6 * 40 * 25;  ///< as background.vert.glsl counts its cells

// Taps of the shadow lookup by Shadows. Twelve on a turned spiral leave no visible grain at 1080p.
constexpr std::array<int, 3> kShadowTaps = {0, 1, 12};

std::string definesFor(int shadowTaps) {
    return "#define SHADOW_TAPS " + std::to_string(shadowTaps) + "\n#define MAX_LOOKS " + std::to_string(kMaxLooks) +
           "\n";
}

}  // namespace

Vec3f linearColour(const Vec3f& srgb) {
    return srgb.unaryExpr([](float c) { return c <= 0.04045F ? c / 12.92F : std::pow((c + 0.055F) / 1.055F, 2.4F); });
}

Expected<SolidPass> SolidPass::create() {
    SolidPass pass;
    for (std::size_t i = 0; i < kShadowTaps.size(); ++i) {
        auto program = ShaderProgram::create(
            "solid", definesFor(kShadowTaps[i]), {shaders::kFrame, shaders::kSolidVert},
            {shaders::kFrame, shaders::kColour, shaders::kDither, shaders::kEnvironment, shaders::kSolidFrag});
        if (!program) return Unexpected{program.error()};
        pass.programs_[i] = std::move(*program);
        pass.programs_[i].use();
        pass.programs_[i].set("grainTexture", kGrainUnit);
        pass.programs_[i].set("shadowMap", kShadowUnit);
    }
    auto background = ShaderProgram::create(
        "background", "", {shaders::kFrame, shaders::kColour, shaders::kEnvironment, shaders::kBackgroundVert},
        {shaders::kDither, shaders::kBackgroundFrag});
    if (!background) return Unexpected{background.error()};
    pass.background_ = std::move(*background);
    pass.grain_ = makeGrainTexture();
    pass.frameBuffer_ = gl::Buffer::make();
    pass.noVertices_ = gl::VertexArray::make();
    return pass;
}

void SolidPass::draw(const std::vector<Drawable>& drawables, const PassView& view, const FrameBlock& frame,
                     const Mat4& cullMatrix, Shadows shadows, const ShadowMap& shadowMap) const {
    glBindBuffer(GL_UNIFORM_BUFFER, frameBuffer_.name());
    glBufferData(GL_UNIFORM_BUFFER, sizeof frame, &frame, GL_STREAM_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, kFrameBinding, frameBuffer_.name());
    glActiveTexture(GL_TEXTURE0 + kGrainUnit);
    glBindTexture(GL_TEXTURE_3D, grain_.name());
    glActiveTexture(GL_TEXTURE0 + kShadowUnit);
    glBindTexture(GL_TEXTURE_2D, shadowMap.texture());
    glActiveTexture(GL_TEXTURE0);

    glClear(GL_DEPTH_BUFFER_BIT);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    background_.use();
    glBindVertexArray(noVertices_.name());
    glDrawArrays(GL_TRIANGLES, 0, kBackgroundVertices);
    glEnable(GL_DEPTH_TEST);

    glFrontFace(view.mirrored ? GL_CW : GL_CCW);
    const ShaderProgram& program = programs_[static_cast<std::size_t>(shadows)];
    program.use();
    for (const Drawable& drawable : drawables) drawObject(program, drawable, view, cullMatrix);
    glFrontFace(GL_CCW);
}

void SolidPass::drawObject(const ShaderProgram& program, const Drawable& drawable, const PassView& view,
                           const Mat4& cullMatrix) const {
    const std::vector<Look>& looks = drawable.object->looks;
    assert(!looks.empty() && looks.size() <= kMaxLooks);
    std::array<Eigen::Vector4f, 2 * kMaxLooks> packed;
    for (std::size_t i = 0; i < looks.size(); ++i) {
        const Look& look = looks[i];
        const Vec3f colour = linearColour(look.colour);
        packed[2 * i] = {colour.x(), colour.y(), colour.z(), look.roughness};
        packed[2 * i + 1] = {look.metalness, look.translucency, look.wetness, look.grain};
    }
    program.setAll("looks", packed.data(), static_cast<int>(2 * looks.size()));
    program.set("lookCount", static_cast<int>(looks.size()));
    program.set("objectToWorld", drawable.objectToWorld);
    const bool closed = drawable.object->closed;
    closed ? glEnable(GL_CULL_FACE) : glDisable(GL_CULL_FACE);
    const Eigen::Vector4d eyeInObject = drawable.objectToWorld.inverse() * view.eye.homogeneous();
    drawable.buffers->draw({cullMatrix * drawable.objectToWorld, eyeInObject, closed});
}

}  // namespace tactooth
