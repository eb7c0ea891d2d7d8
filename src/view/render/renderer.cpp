// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/render/renderer.h"

#include "view/camera/magnifier.h"
#include "view/gl/messages.h"
#include "view/gl/reusable_target.h"
#include "view/gl/shape_cache.h"
#include "view/passes/antialiasing_pass.h"
#include "view/passes/ghost_pass.h"
#include "view/passes/id_pass.h"
#include "view/passes/mirror_pass.h"
#include "view/passes/occlusion_pass.h"
#include "view/passes/particle_pass.h"
#include "view/passes/stereo_pass.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace tactooth {

namespace {

/// The render targets of one view.
struct ViewTargets {
    std::array<ReusableTarget, 2> pictures;  ///< one for each eye
    ReusableTarget reflection;
    ReusableTarget shell;
    ReusableTarget ghost;
};

void setKnownState() {
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_CLIP_DISTANCE0);
    glDisable(GL_CLIP_DISTANCE1);
    glStencilMask(~0U);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glCullFace(GL_BACK);
    glFrontFace(GL_CCW);
    glClearDepth(1.0);
    glActiveTexture(GL_TEXTURE0);
}

void leaveCleanState(GLuint target) {
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glBindVertexArray(0);
    glUseProgram(0);
    glBindTexture(GL_TEXTURE_2D, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, target);
}

/// The half space in which sectioned objects are drawn; all of space without a section.
Eigen::Vector4d keptSide(const Scene& scene) {
    if (!scene.section) return {0, 0, 0, 1};
    Eigen::Vector4d kept;
    kept << -scene.section->plane.normal, scene.section->plane.offset;
    return kept;
}

PassView directView(const Scene& scene, const Camera& camera, ImageSize size) {
    PassView view;
    view.section = keptSide(scene);
    view.worldToView = viewMatrix(camera);
    view.viewToClip = projectionMatrix(camera, size.aspect());
    view.eye = camera.cameraInWorld.position;
    return view;
}

/// Restricts drawing to a part of the picture during its lifetime, also when an error ends it.
class Limit {
public:
    explicit Limit(const PixelRectangle& part) {
        glEnable(GL_SCISSOR_TEST);
        to(part);
    }
    ~Limit() { glDisable(GL_SCISSOR_TEST); }
    Limit(const Limit&) = delete;
    Limit& operator=(const Limit&) = delete;

    void to(const PixelRectangle& part) const {
        glScissor(part.low.x(), part.low.y(), part.extent().x(), part.extent().y());
    }
};

void copyPicture(const RenderTarget& from, GLuint to, const PixelRectangle& place) {
    const ImageSize drawn = from.size();
    const bool fits = place.extent() == Eigen::Vector2i(drawn.width, drawn.height);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from.framebuffer());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
    glBlitFramebuffer(0, 0, drawn.width, drawn.height, place.low.x(), place.low.y(), place.high.x(), place.high.y(),
                      GL_COLOR_BUFFER_BIT, fits ? GL_NEAREST : GL_LINEAR);
}

PixelRectangle rowsFromBelow(const CornerRectangle& place, ImageSize picture) {
    const int top = picture.height - place.top;
    return {{place.left, top - place.size.height}, {place.left + place.size.width, top}};
}

ImageSize scaled(ImageSize size, double share) {
    const auto part = [share](int pixels) { return std::max(1, static_cast<int>(std::lround(share * pixels))); };
    return {part(size.width), part(size.height)};
}

}  // namespace

struct Renderer::Parts {
    SolidPass solid;
    MirrorPass mirror;
    GhostPass ghosts;
    OcclusionPass occlusion;
    AntialiasingPass antialiasing;
    ParticlePass particles;
    StereoPass stereo;
    ShadowMap shadows;
    ShapeCache shapes;
    FieldTextures fields;
    ViewTargets whole, second, magnifier;
    std::size_t lastUpload = 0;
    std::optional<IdPass> ids = {};  ///< made when it is needed first

    /// Everything that stays the same for all views of one picture.
    struct Job {
        const Scene& scene;
        const ShapeCache::Result& shapes;
        const RenderSettings& settings;
        ViewTargets& targets;
        ImageSize size;
    };
    void updateShapes(const Scene& scene, const ShapeCache::Result& result, const RenderSettings& settings,
                      ImageSize size);
    /// What the pictures of `scene` will show: the matrices of all their views.
    [[nodiscard]] std::vector<Mat4> viewsOf(const Scene& scene, ImageSize size) const;
    /// Draws the second view into the corner of framebuffer `target`.
    Expected<void> drawSecond(const Job& large, GLuint target, ImageSize size);
    /// Draws the magnified place into the other corner.
    Expected<void> drawMagnified(const Job& large, GLuint target, ImageSize size);
    /// Draws the scene through `camera` into `into`.
    Expected<void> drawEye(const Job& job, const Camera& camera, const RenderTarget& into);
    /// Draws the reflection in the mirror; null if the mirror reflects nothing.
    Expected<const RenderTarget*> drawReflection(const Job& job, const Camera& camera);
    Expected<void> drawScene(const Job& job, const Camera& camera, const RenderTarget& into,
                             const RenderTarget* mirrored);
    [[nodiscard]] SolidInputs inputsFor(const Job& job, const PassView& view, const Background& background,
                                        const Mat4& cullMatrix) const;
    /// Draws the depth of the body around inner objects and ghosts.
    Expected<const RenderTarget*> drawShell(const Job& job, const SolidInputs& inputs);
    /// Draws only the ghosts, in `seen`, and the depth of the body around them; null if there are none.
    Expected<const RenderTarget*> drawGhosts(const Job& job, SolidInputs& inputs, const PixelRectangle& seen);
    /// Draws what has turned to glass over the part `shown` of the bound framebuffer.
    void drawGlass(const Job& job, SolidInputs& inputs, const PixelRectangle& shown) const;
    /// Draws everything except the mirror's glass and what has turned to glass into the part `shown` of `into`, which
    /// stays bound for more. `inputs` are complete except for the shell.
    Expected<void> drawBodies(const Job& job, SolidInputs& inputs, const RenderTarget& into,
                              const PixelRectangle& shown);
};

SolidInputs Renderer::Parts::inputsFor(const Job& job, const PassView& view, const Background& background,
                                       const Mat4& cullMatrix) const {
    const double lodTolerance = lodToleranceAt(view, job.size, job.settings.lodTolerance);
    FrameBlock frame = frameBlock(view, job.scene.lighting, background, shadows.lookup(), job.size, lodTolerance);
    if (job.scene.sight) addSight(frame, *job.scene.sight, view, job.size);
    return {.drawables = job.shapes.drawables,
            .capped = job.shapes.capped,
            .ghosts = job.shapes.ghosts,
            .view = view,
            .size = job.size,
            .frame = frame,
            .cullMatrix = cullMatrix,
            .lodTolerance = lodTolerance,
            .shadows = job.settings.shadows,
            .shadowMap = shadows,
            .fields = fields,
            .glass = glassPixels(frame, job.size)};
}

void Renderer::Parts::drawGlass(const Job& job, SolidInputs& inputs, const PixelRectangle& shown) const {
    const PixelRectangle seen = inputs.glass.within(shown);
    if (seen.empty()) return;
    const Limit limit(seen);
    const Mat4 ofAll = std::exchange(inputs.cullMatrix, cropped(inputs.view.worldToClip(), seen, job.size));
    solid.drawGlass(inputs);
    inputs.cullMatrix = ofAll;
}

Expected<const RenderTarget*> Renderer::Parts::drawShell(const Job& job, const SolidInputs& inputs) {
    const auto target = job.targets.shell.fit(job.size, 0);
    if (target) solid.drawShell(inputs, **target);
    return target;
}

Expected<const RenderTarget*> Renderer::Parts::drawGhosts(const Job& job, SolidInputs& inputs,
                                                          const PixelRectangle& seen) {
    if (seen.empty()) return nullptr;
    const Limit limit(seen);
    const Mat4 ofAll = std::exchange(inputs.cullMatrix, cropped(inputs.view.worldToClip(), seen, job.size));
    if (inputs.shell == nullptr) {
        const auto around = drawShell(job, inputs);
        if (!around) return around;
        inputs.shell = *around;
    }
    const auto target = job.targets.ghost.fit(job.size, job.settings.samples);
    if (target) ghosts.draw(inputs, **target);
    inputs.cullMatrix = ofAll;
    return target;
}

Expected<void> Renderer::Parts::drawBodies(const Job& job, SolidInputs& inputs, const RenderTarget& into,
                                           const PixelRectangle& shown) {
    if (showsLayers(inputs.drawables)) {
        const Limit limit(shown);
        const auto around = drawShell(job, inputs);
        if (!around) return Unexpected{around.error()};
        inputs.shell = *around;
    }
    const PixelRectangle ghostRegion = ghostPixels(inputs.ghosts, inputs.view, job.size).within(shown);
    const auto seen = drawGhosts(job, inputs, ghostRegion);
    if (!seen) return Unexpected{seen.error()};
    const Limit limit(shown);
    into.bindForDrawing();
    solid.drawOpaque(inputs);
    if (*seen != nullptr) {
        limit.to(ghostRegion);
        ghosts.compose(**seen);
        limit.to(shown);
    }
    solid.drawTransparent(inputs);
    return {};
}

Expected<const RenderTarget*> Renderer::Parts::drawReflection(const Job& job, const Camera& camera) {
    const auto& disc = job.scene.mirror;
    const PixelRectangle covered = disc ? coveredPixels(*disc, camera, job.size) : PixelRectangle{};
    if (covered.empty()) return nullptr;
    const auto target = job.targets.reflection.fit(job.size, job.settings.samples);
    if (!target) return target;
    const PassView view = reflectedView(directView(job.scene, camera, job.size), disc->planeInWorld());
    Background surgery = job.scene.background;
    surgery.kind = Background::Kind::Environment;
    glEnable(GL_CLIP_DISTANCE0);
    SolidInputs inputs = inputsFor(job, view, surgery, cropped(view.worldToClip(), covered, job.size));
    if (const auto done = drawBodies(job, inputs, **target, covered); !done) return Unexpected{done.error()};
    drawGlass(job, inputs, covered);
    {
        const Limit limit(covered);
        particles.draw(job.scene.particles, view, job.size);
        glDisable(GL_CLIP_DISTANCE0);
        (*target)->resolve();
    }
    if (job.settings.ambientOcclusion) {
        if (const auto done = occlusion.apply(**target, covered, camera); !done) return Unexpected{done.error()};
    }
    return target;
}

Expected<void> Renderer::Parts::drawScene(const Job& job, const Camera& camera, const RenderTarget& into,
                                          const RenderTarget* mirrored) {
    const PassView view = directView(job.scene, camera, job.size);
    glEnable(GL_DEPTH_TEST);
    SolidInputs inputs = inputsFor(job, view, job.scene.background, view.worldToClip());
    if (auto done = drawBodies(job, inputs, into, PixelRectangle::whole(job.size)); !done) return done;
    if (mirrored != nullptr) {
        mirror.draw(*job.scene.mirror, inputs.frame, *mirrored, coveredPixels(*job.scene.mirror, camera, job.size));
    }
    drawGlass(job, inputs, PixelRectangle::whole(job.size));
    particles.draw(job.scene.particles, view, job.size);
    into.resolve();
    if (job.settings.ambientOcclusion) {
        if (auto done = occlusion.apply(into, PixelRectangle::whole(into.size()), camera); !done) return done;
    }
    if (job.settings.antialiasing && into.samples() == 0) antialiasing.apply(into);
    return {};
}

Expected<void> Renderer::Parts::drawEye(const Job& job, const Camera& camera, const RenderTarget& into) {
    const auto mirrored = drawReflection(job, camera);
    if (!mirrored) return Unexpected{mirrored.error()};
    return drawScene(job, camera, into, *mirrored);
}

Expected<void> Renderer::Parts::drawSecond(const Job& large, GLuint target, ImageSize size) {
    const CornerRectangle place = secondViewRectangle(size);
    ShapeCache::Result shown = large.shapes;
    std::erase_if(shown.drawables,
                  [](const Drawable& drawable) { return drawable.object->handle || drawable.object->backdrop; });
    const Job job{large.scene, shown, large.settings, second, scaled(place.size, large.settings.resolution)};
    const auto picture = second.pictures[0].fit(job.size, job.settings.samples);
    if (!picture) return Unexpected{picture.error()};
    if (const auto done = drawScene(job, large.scene.second->camera, **picture, nullptr); !done) return done;
    copyPicture(**picture, target, rowsFromBelow(place, size));
    return {};
}

Expected<void> Renderer::Parts::drawMagnified(const Job& large, GLuint target, ImageSize size) {
    const CornerRectangle place = magnifierRectangle(size);
    const Job job{large.scene, large.shapes, large.settings, magnifier, scaled(place.size, large.settings.resolution)};
    const auto picture = magnifier.pictures[0].fit(job.size, job.settings.samples);
    if (!picture) return Unexpected{picture.error()};
    const Camera camera = magnifierCamera(large.scene.camera, size, *large.scene.magnified);
    if (const auto done = drawScene(job, camera, **picture, nullptr); !done) return done;
    copyPicture(**picture, target, rowsFromBelow(place, size));
    return {};
}

std::vector<Mat4> Renderer::Parts::viewsOf(const Scene& scene, ImageSize size) const {
    std::vector<Mat4> views;
    const auto add = [&](const Camera& camera, ImageSize of) {
        const PassView direct = directView(scene, camera, of);
        views.push_back(direct.worldToClip());
        const PixelRectangle covered = scene.mirror ? coveredPixels(*scene.mirror, camera, of) : PixelRectangle{};
        if (covered.empty()) return;
        const PassView reflected = reflectedView(direct, scene.mirror->planeInWorld());
        views.push_back(cropped(reflected.worldToClip(), covered, of));
    };
    if (scene.stereo.mode == Stereo::Mode::Off) {
        add(scene.camera, size);
        if (scene.second) add(scene.second->camera, secondViewRectangle(size).size);
        if (scene.magnified) {
            add(magnifierCamera(scene.camera, size, *scene.magnified), magnifierRectangle(size).size);
        }
    } else {
        for (const Camera& eye : stereoCameras(scene.camera, scene.stereo)) add(eye, size);
    }
    return views;
}

void Renderer::Parts::updateShapes(const Scene& scene, const ShapeCache::Result& result, const RenderSettings& settings,
                                   ImageSize size) {
    lastUpload = result.uploadedTriangles;
    fields.update(result.drawables);
    if (settings.shadows == Shadows::None) {
        shadows.invalidate();
        return;
    }
    shadows.update(result.drawables, result.staticShapesRemoved, scene.lighting.toKey, keptSide(scene),
                   settings.lodTolerance, viewsOf(scene, size));
}

Expected<Renderer> Renderer::create() {
    if (epoxy_gl_version() < 41 || !epoxy_is_desktop_gl()) {
        return unexpected(msg::kOpenGlTooOld, epoxy_gl_version() / 10, epoxy_gl_version() % 10);
    }
    auto solid = SolidPass::create();
    if (!solid) return Unexpected{solid.error()};
    auto mirror = MirrorPass::create();
    if (!mirror) return Unexpected{mirror.error()};
    auto ghosts = GhostPass::create();
    if (!ghosts) return Unexpected{ghosts.error()};
    auto occlusion = OcclusionPass::create();
    if (!occlusion) return Unexpected{occlusion.error()};
    auto particles = ParticlePass::create();
    if (!particles) return Unexpected{particles.error()};
    auto stereo = StereoPass::create();
    if (!stereo) return Unexpected{stereo.error()};
    auto shadows = ShadowMap::create();
    if (!shadows) return Unexpected{shadows.error()};
    const auto problem = gl::checkErrors(msg::kStartingRenderer);
    if (!problem) return Unexpected{problem.error()};
    return Renderer(std::unique_ptr<Parts>(new Parts{std::move(*solid),
                                                     std::move(*mirror),
                                                     std::move(*ghosts),
                                                     std::move(*occlusion),
                                                     {},
                                                     std::move(*particles),
                                                     std::move(*stereo),
                                                     std::move(*shadows),
                                                     {},
                                                     {},
                                                     {},
                                                     {},
                                                     {},
                                                     0}));
}

Renderer::Renderer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

std::size_t Renderer::lastUpload() const { return parts_->lastUpload; }

Expected<void> Renderer::render(const Scene& scene, unsigned target, ImageSize size, const RenderSettings& settings) {
    if (size.width <= 0 || size.height <= 0) return {};
    setKnownState();
    const ShapeCache::Result shapes = parts_->shapes.update(scene);
    const ImageSize ofEye =
        scene.stereo.mode == Stereo::Mode::SideBySide ? ImageSize{(size.width + 1) / 2, size.height} : size;
    parts_->updateShapes(scene, shapes, settings, ofEye);
    const Parts::Job job{scene, shapes, settings, parts_->whole, scaled(ofEye, settings.resolution)};
    const bool isStereo = scene.stereo.mode != Stereo::Mode::Off;
    const auto eyes = stereoCameras(scene.camera, scene.stereo);
    std::array<const RenderTarget*, 2> drawn = {};
    for (std::size_t i = 0; i < (isStereo ? 2 : 1); ++i) {
        const auto picture = job.targets.pictures[i].fit(job.size, settings.samples);
        if (!picture) return Unexpected{picture.error()};
        drawn[i] = *picture;
        auto done = parts_->drawEye(job, isStereo ? eyes[i] : scene.camera, **picture);
        if (!done) return done;
    }
    if (isStereo) {
        parts_->stereo.draw(*drawn[0], *drawn[1], scene.stereo.mode, target, size);
    } else {
        copyPicture(*drawn[0], target, PixelRectangle::whole(size));
        if (scene.second) {
            if (const auto done = parts_->drawSecond(job, target, size); !done) return done;
        }
        if (scene.magnified) {
            if (const auto done = parts_->drawMagnified(job, target, size); !done) return done;
        }
    }
    leaveCleanState(target);
    return gl::checkErrors(msg::kDrawingPicture);
}

Expected<void> Renderer::identify(const Scene& scene, unsigned target, ImageSize size, const MarkedBall& ball) {
    if (size.width <= 0 || size.height <= 0) return {};
    if (!parts_->ids) {
        auto made = IdPass::create();
        if (!made) return Unexpected{made.error()};
        parts_->ids = std::move(*made);
    }
    setKnownState();
    const RenderSettings exact{.shadows = Shadows::None};
    const ShapeCache::Result shapes = parts_->shapes.update(scene);
    parts_->updateShapes(scene, shapes, exact, size);
    const Parts::Job job{scene, shapes, exact, parts_->whole, size};
    const auto picture = job.targets.pictures[0].fit(size, 0);
    if (!picture) return Unexpected{picture.error()};
    const PassView view = directView(scene, scene.camera, size);
    (*picture)->bindForDrawing();
    parts_->ids->draw(parts_->inputsFor(job, view, scene.background, view.worldToClip()), scene, ball);
    copyPicture(**picture, target, PixelRectangle::whole(size));
    leaveCleanState(target);
    return gl::checkErrors(msg::kDrawingPicture);
}

}  // namespace tactooth
