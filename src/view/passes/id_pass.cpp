// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/passes/id_pass.h"

#include "geometry/util/assert.h"
#include "view/gl/shaders.h"

namespace tactooth {

namespace {

bool isShown(const Drawable& drawable) { return !drawable.isTransparent() && !drawable.object->inner; }

}  // namespace

Expected<IdPass> IdPass::create() {
    IdPass pass;
    auto program = ShaderProgram::create(
        "ids", "#define MAX_APPEARANCES " + std::to_string(kMaxAppearances) + "\n#define RICH 0\n",
        {shaders::kFrame, shaders::kNoise, shaders::kSolidVert}, {shaders::kFrame, shaders::kSight, shaders::kIdFrag});
    if (!program) return Unexpected{program.error()};
    pass.program_ = std::move(*program);
    pass.frameBuffer_ = gl::Buffer::make();
    return pass;
}

void IdPass::draw(const SolidInputs& inputs, const Scene& scene, const MarkedBall& ball) const {
    TACTOOTH_ASSERT(scene.objects.size() < 255);
    glBindBuffer(GL_UNIFORM_BUFFER, frameBuffer_.name());
    glBufferData(GL_UNIFORM_BUFFER, sizeof inputs.frame, &inputs.frame, GL_STREAM_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, kFrameBinding, frameBuffer_.name());
    glClearColor(0, 0, 1, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    program_.use();
    const auto extended = [](const Vec3& v, double last) {
        return Eigen::Vector4f(Eigen::Vector4d(v.x(), v.y(), v.z(), last).cast<float>());
    };
    const Plane mirror = scene.mirror ? scene.mirror->planeInWorld() : Plane{Vec3::Zero(), 0};
    program_.set("ball", extended(ball.centre, ball.radius));
    program_.set("mirrorPlane", extended(mirror.normal, mirror.offset));
    program_.set("appearanceCount", 1);
    for (const Drawable& drawable : inputs.drawables) {
        if (isShown(drawable)) drawObject(inputs, scene, drawable, mayTurnToGlass(inputs, drawable) ? 1 : 0);
    }
    // Glass takes its share of the light that comes from behind it, and leaves the rest of the id as it is.
    glDepthMask(GL_FALSE);
    glColorMask(GL_FALSE, GL_FALSE, GL_TRUE, GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
    for (const Drawable& drawable : inputs.drawables) {
        if (isShown(drawable) && mayTurnToGlass(inputs, drawable)) drawObject(inputs, scene, drawable, 2);
    }
    glDisable(GL_BLEND);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glDisable(GL_CLIP_DISTANCE1);
}

void IdPass::drawObject(const SolidInputs& inputs, const Scene& scene, const Drawable& drawable, int phase) const {
    const SceneObject& object = *drawable.object;
    program_.set("objectToWorld", drawable.objectToWorld);
    program_.set("object", static_cast<int>(&object - scene.objects.data()) + 1);
    program_.set("glassPhase", phase);
    program_.set("glassAbove", object.glassAbove.value_or(kAllGlass));
    const bool hidesBack =
        drawable.cullsBackFaces(scene.section.has_value()) && !(phase == 1 && isOpenedByGlass(inputs, drawable));
    hidesBack ? glEnable(GL_CULL_FACE) : glDisable(GL_CULL_FACE);
    object.sectioned ? glEnable(GL_CLIP_DISTANCE1) : glDisable(GL_CLIP_DISTANCE1);
    drawable.buffers->draw(cullerFor(inputs, drawable, hidesBack, 0));
}

}  // namespace tactooth
