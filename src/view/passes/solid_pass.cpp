// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/passes/solid_pass.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "view/gl/noise_texture.h"
#include "view/gl/shaders.h"
#include "view/passes/appearance_uniforms.h"
#include "view/passes/draw_order.h"

namespace tactooth {

namespace {

constexpr int kNoiseUnit = 0;
constexpr int kShadowUnit = 1;
constexpr int kShellUnit = 2;
constexpr int kFieldUnit = 3;
constexpr int kFieldColoursUnit = 4;
constexpr int kShadowDepthUnit = 8;  ///< GhostPass uses 5 to 7. No other pass uses 8, so that its sampler stays bound
constexpr int kBackgroundVertices = 6 * 40 * 25;  ///< the number of cells in background.vert.glsl

/// Samples of the shadow lookup.
struct ShadowTaps {
    int blockers;  ///< that look for what throws the shadow
    int light;     ///< that compute how much light arrives
};
// By Shadows. Twelve on a rotated spiral leave no visible noise at 1080p. A penumbra that widens is up to three and a
// half times as wide and needs more. It is drawn only at rest, where thirty samples in all are cheap enough.
constexpr std::array<ShadowTaps, 4> kShadowTaps = {{{0, 0}, {0, 1}, {0, 12}, {12, 18}}};

/// What a program can do besides lighting a surface. A software renderer computes both sides of each condition, so that
/// a program has only what its objects need.
struct Abilities {
    bool rich = false;      ///< glass, transparency, distances
    bool liquids = false;   ///< SurfaceLiquids
    bool machined = false;  ///< Finish::Machined
    bool tissue = false;    ///< no metal
};

std::string definesFor(ShadowTaps taps, const Abilities& abilities) {
    return "#define SHADOW_TAPS " + std::to_string(taps.light) + "\n#define BLOCKER_TAPS " +
           std::to_string(taps.blockers) + "\n#define MAX_APPEARANCES " + std::to_string(kMaxAppearances) +
           "\n#define RICH " + std::to_string(abilities.rich ? 1 : 0) + "\n" +
           (abilities.liquids ? "#define LIQUIDS\n" : "") + (abilities.machined ? "#define MACHINED\n" : "") +
           (abilities.tissue ? "#define TISSUE\n" : "");
}

Expected<ShaderProgram> lit(std::string_view vertex, ShadowTaps taps, const Abilities& abilities) {
    auto program = ShaderProgram::create("solid", definesFor(taps, abilities),
                                         {shaders::kFrame, shaders::kNoise, shaders::kLiquids, vertex},
                                         {shaders::kFrame, shaders::kColour, shaders::kDither, shaders::kEnvironment,
                                          shaders::kMachined, shaders::kSight, shaders::kSolidFrag});
    if (!program) return program;
    program->use();
    program->set("noiseTexture", kNoiseUnit);
    program->set("shadowMap", kShadowUnit);
    program->set("shadowDepth", kShadowDepthUnit);
    program->set("shellDepth", kShellUnit);
    program->set("distanceField", kFieldUnit);
    program->set("distanceColours", kFieldColoursUnit);
    return program;
}

/// Quick pictures by software have no time for it: the handpiece covers a large part of them.
bool isMachined(const SolidInputs& inputs, const Drawable& drawable) {
    if (inputs.shadows != Shadows::Soft && inputs.shadows != Shadows::Widening) return false;
    return std::ranges::all_of(drawable.object->appearances,
                               [](const Appearance& appearance) { return appearance.finish == Finish::Machined; });
}

bool isTissue(const Drawable& drawable) {
    return std::ranges::all_of(drawable.object->appearances,
                               [](const Appearance& appearance) { return appearance.metalness == 0; });
}

bool isWet(const Drawable& drawable) {
    return drawable.object->liquids.water > 0 || drawable.object->liquids.blood > 0;
}

bool isRich(const SolidInputs& inputs, const Drawable& drawable) {
    return drawable.object->inner || drawable.object->distances || drawable.isTransparent() ||
           mayTurnToGlass(inputs, drawable) || isMachined(inputs, drawable);
}

void setLiquids(const ShaderProgram& program, const SurfaceLiquids& liquids) {
    const auto at = [](const Vec3& place, double amount) {
        return Eigen::Vector4d(place.x(), place.y(), place.z(), amount).cast<float>().eval();
    };
    program.set("waterFilm", at(liquids.spot, liquids.water));
    program.set("bloodFilm", at(liquids.opening, liquids.blood));
    program.set("slurry", static_cast<float>(liquids.slurry));
}

bool hasSection(const SolidInputs& inputs) { return !inputs.view.section.head<3>().isZero(); }

/// The LOD tolerance of `drawable`, in mm for each mm of distance. A body and the layers in it share parts of their
/// surfaces. Where both are visible they stay exact, or one would show through the other.
double lodToleranceFor(const SolidInputs& inputs, const Drawable& drawable) {
    const bool inLayers = drawable.object->sectioned && (hasSection(inputs) || showsLayers(inputs.drawables));
    if (inLayers || drawable.object->inner) return 0;
    return inputs.lodTolerance;
}

}  // namespace

ClusterCuller cullerFor(const SolidInputs& inputs, const Drawable& drawable, bool skipBackFaces, double lodTolerance) {
    const Eigen::Vector4d eyeInObject = drawable.objectToWorld.inverse() * inputs.view.eye.homogeneous();
    return {inputs.cullMatrix * drawable.objectToWorld, eyeInObject, skipBackFaces, lodTolerance};
}

PixelRectangle glassPixels(const FrameBlock& frame, ImageSize size) {
    if (frame.sightReach.w() <= 0) return {};
    constexpr float kMostWidening = 3, kSoftEdge = 0.35F;  // as in sight.glsl
    const float reach =
        (1 + kSoftEdge) * (std::max(frame.sightReach.y(), frame.sightReach.z()) + kMostWidening * frame.sightReach.w());
    const Eigen::Array2f first = frame.sightEnds.head<2>(), last = frame.sightEnds.tail<2>();
    const Eigen::Array2f most(static_cast<float>(size.width), static_cast<float>(size.height));
    const auto pixels = [&](const Eigen::Array2f& place) -> Eigen::Vector2i {
        return place.max(0).min(most).matrix().cast<int>();
    };
    return {pixels((first.min(last) - reach).floor()), pixels((first.max(last) + reach).ceil())};
}

bool mayTurnToGlass(const SolidInputs& inputs, const Drawable& drawable) {
    if (!drawable.object->glassAbove || inputs.glass.empty()) return false;
    // The box in the normalised coordinates of the part of the picture that has glass.
    const Mat4 toPart = cropped(inputs.view.worldToClip(), inputs.glass, inputs.size) * drawable.objectToWorld;
    const Box3 box = drawable.buffers->box();
    Box3 covered;
    double nearest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 8; ++i) {
        const Eigen::Vector4d corner = toPart * box.corner(static_cast<Box3::CornerType>(i)).homogeneous();
        if (corner.w() <= 0) return true;  // at the eye's plane or behind it
        covered.extend(Vec3(corner.head<3>() / corner.w()));
        nearest = std::min(nearest, corner.w());
    }
    return nearest < static_cast<double>(inputs.frame.sightReach.x()) && covered.min().x() < 1 &&
           covered.max().x() > -1 && covered.min().y() < 1 && covered.max().y() > -1;
}

bool isOpenedByGlass(const SolidInputs& inputs, const Drawable& drawable) {
    return drawable.object->glassAbove && *drawable.object->glassAbove > kAllGlass && mayTurnToGlass(inputs, drawable);
}

bool showsLayers(const std::vector<Drawable>& drawables) {
    return std::any_of(drawables.begin(), drawables.end(),
                       [](const Drawable& drawable) { return drawable.object->inner; });
}

Expected<SolidPass> SolidPass::create() {
    SolidPass pass;
    for (std::size_t i = 0; i < kShadowTaps.size(); ++i) {
        auto plain = lit(shaders::kSolidVert, kShadowTaps[i], {});
        if (!plain) return Unexpected{plain.error()};
        auto wet = lit(shaders::kSolidVert, kShadowTaps[i], {.liquids = true});
        if (!wet) return Unexpected{wet.error()};
        auto tissue = lit(shaders::kSolidVert, kShadowTaps[i], {.tissue = true});
        if (!tissue) return Unexpected{tissue.error()};
        auto wetTissue = lit(shaders::kSolidVert, kShadowTaps[i], {.liquids = true, .tissue = true});
        if (!wetTissue) return Unexpected{wetTissue.error()};
        auto rich = lit(shaders::kSolidVert, kShadowTaps[i], {.rich = true, .liquids = true});
        if (!rich) return Unexpected{rich.error()};
        auto machined = lit(shaders::kSolidVert, kShadowTaps[i], {.rich = true, .machined = true});
        if (!machined) return Unexpected{machined.error()};
        auto section = lit(shaders::kSectionVert, kShadowTaps[i], {});
        if (!section) return Unexpected{section.error()};
        pass.variants_[i] = {std::move(*plain), std::move(*wet),      std::move(*tissue), std::move(*wetTissue),
                             std::move(*rich),  std::move(*machined), std::move(*section)};
    }
    auto background = ShaderProgram::create(
        "background", "", {shaders::kFrame, shaders::kColour, shaders::kEnvironment, shaders::kBackgroundVert},
        {shaders::kDither, shaders::kBackgroundFrag});
    if (!background) return Unexpected{background.error()};
    auto depth = ShaderProgram::create("depth", "", {shaders::kDepthVert}, {shaders::kNothingFrag});
    if (!depth) return Unexpected{depth.error()};
    pass.background_ = std::move(*background);
    pass.depth_ = std::move(*depth);
    pass.noiseTexture_ = makeNoiseTexture();
    pass.frameBuffer_ = gl::Buffer::make();
    pass.noVertices_ = gl::VertexArray::make();
    return pass;
}

void SolidPass::prepare(const SolidInputs& inputs) const {
    glBindBuffer(GL_UNIFORM_BUFFER, frameBuffer_.name());
    glBufferData(GL_UNIFORM_BUFFER, sizeof inputs.frame, &inputs.frame, GL_STREAM_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, kFrameBinding, frameBuffer_.name());
    gl::bindTexture(kNoiseUnit, GL_TEXTURE_3D, noiseTexture_.name());
    gl::bindTexture(kShadowUnit, GL_TEXTURE_2D, inputs.shadowMap.texture());
    gl::bindTexture(kShadowDepthUnit, GL_TEXTURE_2D, inputs.shadowMap.texture());
    glBindSampler(kShadowDepthUnit, inputs.shadowMap.depthSampler());
    gl::bindTexture(kShellUnit, GL_TEXTURE_2D, inputs.shell != nullptr ? inputs.shell->depthTexture() : 0);
    gl::bindTexture(kFieldColoursUnit, GL_TEXTURE_2D, inputs.fields.colours());
}

void SolidPass::drawBackground() const {
    // Both share a buffer. To clear only one of them takes a software renderer four times as long.
    glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    background_.use();
    glBindVertexArray(noVertices_.name());
    glDrawArrays(GL_TRIANGLES, 0, kBackgroundVertices);
    glEnable(GL_DEPTH_TEST);
}

void SolidPass::drawOpaque(const SolidInputs& inputs) const {
    prepare(inputs);
    drawBackground();
    glFrontFace(inputs.view.mirrored ? GL_CW : GL_CCW);
    const bool marks = !inputs.ghosts.empty();
    if (marks) beginStencil();
    std::vector<PlacedBox> bodies;
    for (const Drawable& one : inputs.drawables) bodies.push_back({one.buffers->box(), one.objectToWorld});
    for (const std::size_t i : nearestFirst(bodies, inputs.view.eye)) {
        const Drawable& drawable = inputs.drawables[i];
        if (drawable.isTransparent()) continue;
        if (marks) glStencilFunc(GL_ALWAYS, drawable.object->sectioned ? kStencilSeenThrough : 0, ~0U);
        drawObject(inputs, drawable);
    }
    if (marks) endStencil();
    if (hasSection(inputs)) drawSectionCaps(inputs);
    glFrontFace(GL_CCW);
    glDisable(GL_CLIP_DISTANCE1);
}

/// From here on, drawing writes the reference value of the stencil function into kStencilSeenThrough.
void SolidPass::beginStencil() {
    glStencilMask(kStencilSeenThrough);
    glEnable(GL_STENCIL_TEST);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
}

void SolidPass::endStencil() {
    glDisable(GL_STENCIL_TEST);
    glStencilMask(~0U);
}

void SolidPass::drawTransparent(const SolidInputs& inputs) const {
    glFrontFace(inputs.view.mirrored ? GL_CW : GL_CCW);
    for (auto drawable = inputs.drawables.rbegin(); drawable != inputs.drawables.rend(); ++drawable) {
        if (drawable->isTransparent()) drawBlended(inputs, *drawable);
    }
    glFrontFace(GL_CCW);
    glDisable(GL_CLIP_DISTANCE1);
}

void SolidPass::drawGlass(const SolidInputs& inputs) const {
    prepare(inputs);
    glFrontFace(inputs.view.mirrored ? GL_CW : GL_CCW);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    for (const Drawable& drawable : inputs.drawables) {
        if (!drawable.isTransparent() && mayTurnToGlass(inputs, drawable)) drawObject(inputs, drawable, Part::Glass);
    }
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
    glFrontFace(GL_CCW);
    glDisable(GL_CLIP_DISTANCE1);
}

void SolidPass::drawObject(const SolidInputs& inputs, const Drawable& drawable, Part part) const {
    const Variant& variant = variants_[static_cast<std::size_t>(inputs.shadows)];
    const bool rich = isRich(inputs, drawable);
    const bool wet = isWet(drawable), machined = isMachined(inputs, drawable), tissue = isTissue(drawable);
    const ShaderProgram& program = machined ? variant.machined
                                   : rich   ? variant.rich
                                   : tissue ? (wet ? variant.wetTissue : variant.tissue)
                                            : (wet ? variant.wet : variant.plain);
    program.use();
    setAppearances(program, drawable.object->appearances);
    program.set("appearanceCount", static_cast<int>(drawable.object->appearances.size()));
    program.set("secondAbove", drawable.object->secondAbove.value_or(0.0F));
    program.set("objectToWorld", drawable.objectToWorld);
    program.set("sectioned", drawable.object->sectioned ? 1 : 0);
    if (!machined && (rich || wet)) setLiquids(program, drawable.object->liquids);
    if (rich) setRichUniforms(program, inputs, drawable, part);
    const bool hidesBack =
        drawable.cullsBackFaces(hasSection(inputs)) && !(part == Part::Solid && isOpenedByGlass(inputs, drawable));
    hidesBack ? glEnable(GL_CULL_FACE) : glDisable(GL_CULL_FACE);
    drawable.object->sectioned ? glEnable(GL_CLIP_DISTANCE1) : glDisable(GL_CLIP_DISTANCE1);
    // Where a layer reaches the surface of the body, the body is visible.
    if (drawable.object->inner) glEnable(GL_POLYGON_OFFSET_FILL), glPolygonOffset(1.0F, 4.0F);
    drawable.buffers->draw(cullerFor(inputs, drawable, hidesBack, lodToleranceFor(inputs, drawable)));
    glDisable(GL_POLYGON_OFFSET_FILL);
}

void SolidPass::setRichUniforms(const ShaderProgram& program, const SolidInputs& inputs, const Drawable& drawable,
                                Part part) const {
    setOpacities(program, drawable.object->appearances);
    program.set("glassPhase", !mayTurnToGlass(inputs, drawable) ? 0 : part == Part::Solid ? 1 : 2);
    program.set("glassAbove", drawable.object->glassAbove.value_or(kAllGlass));
    program.set("inner", drawable.object->inner && inputs.shell != nullptr ? 1 : 0);
    const auto& distances = drawable.object->distances;
    program.set("distanceRange", distances ? static_cast<float>(distances->scale.range) : 0.0F);
    if (!distances) return;
    program.set("distanceTolerance", static_cast<float>(distances->scale.tolerance));
    program.set("toleranceStep", static_cast<float>(kToleranceStep));
    gl::bindTexture(kFieldUnit, GL_TEXTURE_3D, inputs.fields.of(distances->grid.get()));
    program.set("objectToField", objectToField(*distances->grid));
}

/// Draws only its nearest faces, so that their order does not matter: first their depth, then their colour.
void SolidPass::drawBlended(const SolidInputs& inputs, const Drawable& drawable) const {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    drawObject(inputs, drawable);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    drawObject(inputs, drawable);
    glDisable(GL_BLEND);
    glDepthFunc(GL_LESS);
}

void SolidPass::drawShell(const SolidInputs& inputs, const RenderTarget& into) const {
    into.bindForDrawing();
    glEnable(GL_DEPTH_TEST);
    glClear(GL_DEPTH_BUFFER_BIT);
    const auto body = std::find_if(inputs.drawables.begin(), inputs.drawables.end(), [](const Drawable& drawable) {
        return drawable.object->sectioned && !drawable.object->inner;
    });
    if (body == inputs.drawables.end()) return;
    stencilInside(inputs, *body, 0);
}

/// With `bit` 0 draws depth. Otherwise each face of the drawable toggles `bit` of the stencil, so that it is set where
/// the section plane is inside the drawable.
void SolidPass::stencilInside(const SolidInputs& inputs, const Drawable& drawable, GLuint bit) const {
    depth_.use();
    depth_.set("objectToClip", Mat4(inputs.view.worldToClip() * drawable.objectToWorld));
    const auto inObject = [&](const Eigen::Vector4d& plane) {
        return Eigen::Vector4f((drawable.objectToWorld.transpose() * plane).cast<float>());
    };
    depth_.set("clipInObject", inObject(inputs.view.clipPlane));
    depth_.set("sectionInObject", inObject(inputs.view.section));
    glDisable(GL_CULL_FACE);
    glEnable(GL_CLIP_DISTANCE1);
    if (bit != 0) {
        glEnable(GL_STENCIL_TEST);
        glStencilMask(bit);
        glClear(GL_STENCIL_BUFFER_BIT);
        glStencilFunc(GL_ALWAYS, 0, ~0U);
        glStencilOp(GL_INVERT, GL_INVERT, GL_INVERT);
        glDisable(GL_DEPTH_TEST);
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    }
    drawable.buffers->draw(cullerFor(inputs, drawable, false, lodToleranceFor(inputs, drawable)));
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_STENCIL_TEST);
    glStencilMask(~0U);
}

/// Draws the section caps from the outside in: first the body, then its layers over it, where the body still exists.
void SolidPass::drawSectionCaps(const SolidInputs& inputs) const {
    constexpr GLuint kBody = 1, kLayer = 2;
    // One square for all caps, so that all have the same depth.
    const Box3 around = inputs.capped.empty() ? Box3() : boxOf(inputs.capped.front(), Mat4::Identity());
    for (const Drawable& drawable : inputs.capped) {
        const GLuint bit = drawable.object->inner ? kLayer : kBody;
        stencilInside(inputs, drawable, bit);
        const GLuint wanted = kBody | bit;
        glEnable(GL_STENCIL_TEST);
        glStencilMask(kStencilSeenThrough);
        glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
        glStencilFunc(GL_EQUAL, static_cast<GLint>(wanted) | kStencilSeenThrough, wanted);
        glDepthFunc(GL_LEQUAL);  // all caps are in one plane: the last one wins
        drawCap(inputs, around, *drawable.object->capAppearance);
        glDepthFunc(GL_LESS);
        endStencil();
    }
}

void SolidPass::drawCap(const SolidInputs& inputs, const Box3& around, const Appearance& appearance) const {
    const Vec3 normal = inputs.view.section.head<3>();
    const double offset = normal.dot(around.center()) + inputs.view.section.w();
    const Vec3 centre = around.center() - offset * normal;
    const double reach = 0.5 * around.diagonal().norm() + std::abs(offset);
    const Vec3 right = reach * normal.unitOrthogonal();
    const ShaderProgram& program = variants_[static_cast<std::size_t>(inputs.shadows)].section;
    program.use();
    setAppearances(program, {appearance});
    const auto extended = [](const Vec3& v) { return Eigen::Vector4f(v.homogeneous().cast<float>()); };
    program.set("centre", extended(centre));
    program.set("right", extended(right));
    program.set("up", extended(right.cross(normal)));  // counter-clockwise as seen from the open side
    glDisable(GL_CULL_FACE);
    glBindVertexArray(noVertices_.name());
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

}  // namespace tactooth
