// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/renderer.h"

#include "view/mirror_pass.h"
#include "view/occlusion_pass.h"
#include "view/shape_cache.h"

#include <algorithm>
#include <cmath>

namespace tactooth {

namespace {

/// A picture that is made again only when its size or its samples change.
class ReusedTarget {
public:
    Expected<const RenderTarget*> fit(PictureSize size, int samples) {
        if (!target_ || target_->size() != size || asked_ != samples) {
            target_.reset();
            auto made = RenderTarget::create(size, samples);
            if (!made) return Unexpected{made.error()};
            target_ = std::move(*made);
            asked_ = samples;
        }
        return &*target_;
    }

private:
    std::optional<RenderTarget> target_;
    int asked_ = 0;
};

void setKnownState() {
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_CLIP_DISTANCE0);
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

PassView directView(const Camera& camera, PictureSize size) {
    PassView view;
    view.worldToView = viewMatrix(camera);
    view.viewToClip = projectionMatrix(camera, size.aspect());
    view.eye = camera.cameraInWorld.position;
    return view;
}

void copyPicture(const RenderTarget& from, GLuint to, PictureSize size) {
    const PictureSize drawn = from.size();
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from.framebuffer());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
    glBlitFramebuffer(0, 0, drawn.width, drawn.height, 0, 0, size.width, size.height, GL_COLOR_BUFFER_BIT,
                      drawn == size ? GL_NEAREST : GL_LINEAR);
}

PictureSize scaled(PictureSize size, double share) {
    const auto part = [share](int pixels) { return std::max(1, static_cast<int>(std::lround(share * pixels))); };
    return {part(size.width), part(size.height)};
}

}  // namespace

struct Renderer::Parts {
    SolidPass solid;
    MirrorPass mirror;
    OcclusionPass occlusion;
    ShadowMap shadows;
    ShapeCache shapes;
    ReusedTarget picture;
    ReusedTarget reflection;
    std::size_t lastUpload = 0;

    /// Draws what the mirror shows; nothing if it shows nothing.
    Expected<const RenderTarget*> drawReflection(const Scene& scene, const std::vector<Drawable>& drawables,
                                                 const PassView& direct, PictureSize size,
                                                 const RenderSettings& settings);
    Expected<void> drawScene(const Scene& scene, const std::vector<Drawable>& drawables, const PassView& view,
                             const RenderTarget& into, const RenderTarget* mirrored, const RenderSettings& settings);
};

Expected<const RenderTarget*> Renderer::Parts::drawReflection(const Scene& scene,
                                                              const std::vector<Drawable>& drawables,
                                                              const PassView& direct, PictureSize size,
                                                              const RenderSettings& settings) {
    const PixelRectangle covered = scene.mirror ? coveredPixels(*scene.mirror, scene.camera, size) : PixelRectangle{};
    if (covered.empty()) return nullptr;
    const auto target = reflection.fit(size, settings.samples);
    if (!target) return target;
    const PassView view = reflectedView(direct, scene.mirror->planeInWorld());
    Background surgery = scene.background;
    surgery.kind = Background::Kind::Environment;
    (*target)->bindForDrawing();
    glEnable(GL_SCISSOR_TEST);
    glScissor(covered.low.x(), covered.low.y(), covered.extent().x(), covered.extent().y());
    glEnable(GL_CLIP_DISTANCE0);
    solid.draw(drawables, view, frameBlock(view, scene.lighting, surgery, shadows.lookup(), size),
               cropped(view.worldToClip(), covered, size), settings.shadows, shadows);
    glDisable(GL_CLIP_DISTANCE0);
    (*target)->resolve();
    glDisable(GL_SCISSOR_TEST);
    if (settings.ambientOcclusion) {
        if (const auto done = occlusion.apply(**target, covered, scene.camera); !done) return Unexpected{done.error()};
    }
    return target;
}

Expected<void> Renderer::Parts::drawScene(const Scene& scene, const std::vector<Drawable>& drawables,
                                          const PassView& view, const RenderTarget& into, const RenderTarget* mirrored,
                                          const RenderSettings& settings) {
    const FrameBlock frame = frameBlock(view, scene.lighting, scene.background, shadows.lookup(), into.size());
    glEnable(GL_DEPTH_TEST);
    into.bindForDrawing();
    solid.draw(drawables, view, frame, view.worldToClip(), settings.shadows, shadows);
    if (mirrored != nullptr) mirror.draw(*scene.mirror, frame, *mirrored);
    into.resolve();
    if (!settings.ambientOcclusion) return {};
    return occlusion.apply(into, PixelRectangle::whole(into.size()), scene.camera);
}

Expected<Renderer> Renderer::create() {
    if (epoxy_gl_version() < 41 || !epoxy_is_desktop_gl()) {
        return unexpected("this computer offers OpenGL " + std::to_string(epoxy_gl_version() / 10) + "." +
                          std::to_string(epoxy_gl_version() % 10) +
                          ", but OpenGL 4.1 or newer is needed: update the graphics driver, or set "
                          "LIBGL_ALWAYS_SOFTWARE=1 to draw without it");
    }
    auto solid = SolidPass::create();
    if (!solid) return Unexpected{solid.error()};
    auto mirror = MirrorPass::create();
    if (!mirror) return Unexpected{mirror.error()};
    auto occlusion = OcclusionPass::create();
    if (!occlusion) return Unexpected{occlusion.error()};
    auto shadows = ShadowMap::create();
    if (!shadows) return Unexpected{shadows.error()};
    const auto problem = gl::checkErrors("starting the renderer");
    if (!problem) return Unexpected{problem.error()};
    return Renderer(std::unique_ptr<Parts>(
        new Parts{std::move(*solid), std::move(*mirror), std::move(*occlusion), std::move(*shadows), {}, {}, {}, 0}));
}

Renderer::Renderer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

std::size_t Renderer::lastUpload() const { return parts_->lastUpload; }

Expected<void> Renderer::render(const Scene& scene, unsigned target, PictureSize size, const RenderSettings& settings) {
    if (size.width <= 0 || size.height <= 0) return {};
    setKnownState();
    const ShapeCache::Result shapes = parts_->shapes.update(scene);
    parts_->lastUpload = shapes.uploadedTriangles;
    if (settings.shadows != Shadows::None) {
        parts_->shadows.update(shapes.drawables, shapes.stillShapesChanged, scene.lighting.toKey);
    }
    const PictureSize drawn = scaled(size, settings.resolution);
    const PassView view = directView(scene.camera, drawn);
    const auto picture = parts_->picture.fit(drawn, settings.samples);
    if (!picture) return Unexpected{picture.error()};
    const auto mirrored = parts_->drawReflection(scene, shapes.drawables, view, drawn, settings);
    if (!mirrored) return Unexpected{mirrored.error()};
    if (auto done = parts_->drawScene(scene, shapes.drawables, view, **picture, *mirrored, settings); !done)
        return done;
    copyPicture(**picture, target, size);
    leaveCleanState(target);
    return gl::checkErrors("drawing the picture");
}

}  // namespace tactooth
