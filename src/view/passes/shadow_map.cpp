// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/passes/shadow_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/util/pose.h"
#include "view/gl/messages.h"
#include "view/gl/shaders.h"

namespace tactooth {

namespace {

constexpr int kResolution = 1024;      ///< texels per side: 25 um a texel on a molar
constexpr double kTexelsForPixel = 2;  ///< shadow edges may deviate twice as much as the picture: it is not noticed
constexpr double kMargin = 1.02;       ///< room for the offset of the lookup from the surface

/// The depth range extends beyond the shadow receivers by a multiple of this, mm. A moving tool then leaves the map of
/// the static objects unchanged. 24 bits over a hundred millimetres are 6 nm.
constexpr double kDepthStep = 32;
constexpr int kBorderTexels = 2;  ///< around a change: one texel for rounding, one for its neighbour
constexpr ImageSize kMapSize{kResolution, kResolution};

gl::Framebuffer framebufferFor(const gl::Texture& depth) {
    gl::Framebuffer framebuffer = gl::Framebuffer::make();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth.name(), 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    return framebuffer;
}

gl::Texture depthTexture() {
    gl::Texture texture = gl::Texture::make();
    gl::allocateTexture(texture, GL_DEPTH_COMPONENT24, kResolution, kResolution, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    return texture;
}

gl::Sampler plainSampler() {
    gl::Sampler sampler = gl::Sampler::make();
    glSamplerParameteri(sampler.name(), GL_TEXTURE_COMPARE_MODE, GL_NONE);
    glSamplerParameteri(sampler.name(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glSamplerParameteri(sampler.name(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glSamplerParameteri(sampler.name(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glSamplerParameteri(sampler.name(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return sampler;
}

/// World to a frame with +z toward the light.
Mat4 lightFrame(const Vec3& toLight) {
    Mat4 matrix = Mat4::Identity();
    matrix.topLeftCorner<3, 3>() = shortestRotation(toLight, Vec3::UnitZ()).toRotationMatrix();
    return matrix;
}

/// `all`, with its depth extended in steps from the depth of `receivers`.
Box3 inSteps(const Box3& receivers, Box3 all) {
    const double above = all.max().z() - receivers.max().z();
    const double below = receivers.min().z() - all.min().z();
    all.max().z() = receivers.max().z() + kDepthStep * std::ceil(above / kDepthStep);
    all.min().z() = receivers.min().z() - kDepthStep * std::ceil(below / kDepthStep);
    return all;
}

/// The parallel projection along -z onto the square around the centre of `receivers`, with the depth range of `all`.
Mat4 lightProjection(const Box3& receivers, const Box3& all, double halfWidth) {
    const double depth = std::max(all.sizes().z(), 1e-3) * kMargin;
    Mat4 matrix = Mat4::Identity();
    matrix(0, 0) = matrix(1, 1) = 1 / halfWidth;
    matrix(2, 2) = -2 / depth;
    matrix(0, 3) = -receivers.center().x() / halfWidth;
    matrix(1, 3) = -receivers.center().y() / halfWidth;
    matrix(2, 3) = 2 * all.center().z() / depth;
    return matrix;
}

/// The box in the frame `light` of what the view shows within `bodies`: of the part of its pyramid that is as far from
/// the eye as they are. `bodies`: world frame.
Box3 shownPart(const Mat4& worldToClip, const Box3& bodies, const Mat4& light) {
    const Mat4 clipToWorld = worldToClip.inverse();
    double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
    for (int i = 0; i < 8; ++i) {
        const double away = (worldToClip * bodies.corner(static_cast<Box3::CornerType>(i)).homogeneous()).w();
        nearest = std::min(nearest, away);
        farthest = std::max(farthest, away);
    }
    Box3 shown;
    for (int i = 0; i < 4; ++i) {
        const auto onRay = [&](double depth) -> Vec3 {
            return (clipToWorld * Eigen::Vector4d(i % 2 == 0 ? -1 : 1, i < 2 ? -1 : 1, depth, 1)).hnormalized();
        };
        const Vec3 first = onRay(-1), last = onRay(1);
        const double from = (worldToClip * first.homogeneous()).w(), to = (worldToClip * last.homogeneous()).w();
        for (const double away : {nearest, farthest}) {
            const double part = std::clamp((away - from) / (to - from), 0.0, 1.0);
            shown.extend((light * (first + part * (last - first)).homogeneous()).head<3>());
        }
    }
    return shown;
}

/// `receivers` (light frame) restricted sideways to what the views show of `bodies` (world frame).
Box3 restricted(Box3 receivers, const Box3& bodies, std::span<const Mat4> views, const Mat4& light) {
    if (views.empty() || bodies.isEmpty()) return receivers;
    Box3 shown;
    for (const Mat4& view : views) shown.extend(shownPart(view, bodies, light));
    for (int axis = 0; axis < 2; ++axis) {
        const double low = std::max(receivers.min()[axis], shown.min()[axis]);
        const double high = std::min(receivers.max()[axis], shown.max()[axis]);
        if (low >= high) return receivers;  // nothing of them is in sight
        receivers.min()[axis] = low;
        receivers.max()[axis] = high;
    }
    return receivers;
}

}  // namespace

Expected<ShadowMap> ShadowMap::create() {
    ShadowMap map;
    auto program = ShaderProgram::create("shadow", "", {shaders::kDepthVert}, {shaders::kNothingFrag});
    if (!program) return Unexpected{program.error()};
    map.program_ = std::move(*program);
    map.staticMap_ = depthTexture();
    map.combinedMap_ = depthTexture();
    map.depthSampler_ = plainSampler();
    map.staticFramebuffer_ = framebufferFor(map.staticMap_);
    map.combinedFramebuffer_ = framebufferFor(map.combinedMap_);
    const auto problem = gl::checkErrors(msg::kMakingShadowMap);
    if (!problem) return Unexpected{problem.error()};
    return map;
}

void ShadowMap::fitLightFrustum(const std::vector<Drawable>& drawables, const Vec3& toLight,
                                std::span<const Mat4> views) {
    toLight_ = toLight;
    const Mat4 frame = lightFrame(toLight);
    Box3 receivers;
    Box3 inWorld;
    Box3 all;
    for (const Drawable& drawable : drawables) {
        if (drawable.object->backdrop) continue;
        const Box3 box = boxOf(drawable, frame);
        all.extend(box);
        if (drawable.object->moves) continue;
        receivers.extend(box);
        inWorld.extend(boxOf(drawable, Mat4::Identity()));
    }
    receivers = receivers.isEmpty() ? all : restricted(receivers, inWorld, views, frame);
    const double halfWidth = 0.5 * kMargin * std::max({receivers.sizes().x(), receivers.sizes().y(), 1e-3});
    worldToClip_ = lightProjection(receivers, inSteps(receivers, all), halfWidth) * frame;
    Mat4 clipToTexture = Mat4::Identity();
    clipToTexture.topLeftCorner<3, 3>() *= 0.5;
    clipToTexture.topRightCorner<3, 1>().setConstant(0.5);
    lookup_ = {clipToTexture * worldToClip_, 1.0 / kResolution, 2 * halfWidth / kResolution};
}

PixelRectangle ShadowMap::texelsOf(const Box3& inClip) const {
    if (inClip.isEmpty()) return {};
    const auto texel = [](double clip) { return std::clamp((clip + 1) / 2 * kResolution, -1.0, kResolution + 1.0); };
    const auto below = [&](double clip) { return static_cast<int>(std::floor(texel(clip))) - kBorderTexels; };
    const auto above = [&](double clip) { return static_cast<int>(std::ceil(texel(clip))) + kBorderTexels; };
    const PixelRectangle around{{below(inClip.min().x()), below(inClip.min().y())},
                                {above(inClip.max().x()), above(inClip.max().y())}};
    return around.within(PixelRectangle::whole(kMapSize));
}

PixelRectangle ShadowMap::changedTexels(const std::vector<Drawable>& drawables) const {
    Box3 changed;
    for (const Drawable& drawable : drawables) {
        if (drawable.object->moves) continue;
        changed.extend(transformedBox(drawable.changed, worldToClip_ * drawable.objectToWorld));
    }
    return texelsOf(changed);
}

void ShadowMap::update(const std::vector<Drawable>& drawables, bool staticShapesRemoved, const Vec3& toLight,
                       const Eigen::Vector4d& section, double lodTolerance, std::span<const Mat4> views) {
    if (drawables.empty()) {
        invalidate();
        return;
    }
    fitLightFrustum(drawables, toLight, views);
    lookup_.error = kTexelsForPixel * lodTolerance * lookup_.pitch;
    std::vector<Mat4> poses;
    bool anyTools = false;
    for (const Drawable& drawable : drawables) {
        if (!drawable.object->moves) poses.push_back(drawable.objectToWorld);
        anyTools |= drawable.object->moves;
    }
    glViewport(0, 0, kResolution, kResolution);
    program_.use();
    const bool moved = std::exchange(section_, section) != section;
    const bool refined = std::exchange(lodTolerance_, lodTolerance) != lodTolerance;
    const bool isOld =
        staticShapesRemoved || moved || refined || staticWorldToClip_ != worldToClip_ || poses != staticPoses_;
    const PixelRectangle whole = PixelRectangle::whole(kMapSize);
    drawStatic(drawables, isOld ? whole : changedTexels(drawables));
    staticWorldToClip_ = worldToClip_;
    staticPoses_ = std::move(poses);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, staticFramebuffer_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, combinedFramebuffer_.name());
    glBlitFramebuffer(0, 0, kResolution, kResolution, 0, 0, kResolution, kResolution, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    if (!anyTools) return;
    glBindFramebuffer(GL_FRAMEBUFFER, combinedFramebuffer_.name());
    draw(drawables, true, whole);
}

void ShadowMap::drawStatic(const std::vector<Drawable>& drawables, const PixelRectangle& part) const {
    if (part.empty()) return;
    glBindFramebuffer(GL_FRAMEBUFFER, staticFramebuffer_.name());
    glEnable(GL_SCISSOR_TEST);
    glScissor(part.low.x(), part.low.y(), part.extent().x(), part.extent().y());
    glClear(GL_DEPTH_BUFFER_BIT);
    draw(drawables, false, part);
    glDisable(GL_SCISSOR_TEST);
}

void ShadowMap::draw(const std::vector<Drawable>& drawables, bool tools, const PixelRectangle& part) const {
    const Mat4 worldToPart = cropped(worldToClip_, part, kMapSize);
    // The back faces that a section exposes also throw shadows.
    const bool inSection = !section_.head<3>().isZero();
    // Facets that are steep to the light cover a depth range within one texel: push them back by that range.
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.5F, 4.0F);
    for (const Drawable& drawable : drawables) {
        if (drawable.object->moves != tools || !throwsShadow(*drawable.object)) continue;
        const Mat4 objectToClip = worldToClip_ * drawable.objectToWorld;
        const Vec3 toLightInObject = drawable.objectToWorld.topLeftCorner<3, 3>().transpose() * toLight_;
        const bool closed = drawable.object->closed && !(inSection && drawable.object->sectioned);
        closed ? glEnable(GL_CULL_FACE) : glDisable(GL_CULL_FACE);
        program_.set("objectToClip", objectToClip);
        const bool cut = inSection && drawable.object->sectioned;
        // Mesa's software renderer clips where the plane is switched off, too: see solid.vert.glsl.
        const Eigen::Vector4d kept = cut ? section_ : Eigen::Vector4d(0, 0, 0, 1);
        const Eigen::Vector4d sectionInObject = drawable.objectToWorld.transpose() * kept;
        program_.set("sectionInObject", Eigen::Vector4f(sectionInObject.cast<float>()));
        cut ? glEnable(GL_CLIP_DISTANCE1) : glDisable(GL_CLIP_DISTANCE1);
        drawable.buffers->draw({worldToPart * drawable.objectToWorld,
                                Eigen::Vector4d(toLightInObject.x(), toLightInObject.y(), toLightInObject.z(), 0),
                                closed, lookup_.error});
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_CLIP_DISTANCE1);
}

}  // namespace tactooth
