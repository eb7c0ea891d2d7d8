// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "view/gl/drawable.h"
#include "view/gl/render_target.h"
#include "view/gl/shader_program.h"
#include "view/passes/frame_block.h"

namespace tactooth {

/// The depth buffer as seen from the operating light. Static objects are drawn again only where they change, or when
/// the light changes. The tools of each frame are drawn into a copy.
class ShadowMap {
public:
    [[nodiscard]] static Expected<ShadowMap> create();

    /// `section`: the parts of sectioned objects on the negative side of this plane throw no shadow. `lodTolerance`: as
    /// RenderSettings::lodTolerance, but in texels of the map and twice that. `staticShapesRemoved`: a static shape of
    /// the frame before is not among `drawables`. `views`: the world-to-clip matrices of all views of the frame. The
    /// map covers what they show of the static objects, and nothing else, so that its texels are small; without views
    /// it covers all of them.
    void update(const std::vector<Drawable>& drawables, bool staticShapesRemoved, const Vec3& toLight,
                const Eigen::Vector4d& section, double lodTolerance, std::span<const Mat4> views = {});
    /// Call it for a frame without `update`: the next update draws everything again.
    void invalidate() { staticWorldToClip_.setZero(); }
    /// A lookup in it compares depths.
    [[nodiscard]] GLuint texture() const { return combinedMap_.name(); }
    /// For a unit with `texture`: a lookup there reads the depth itself, of the nearest texel.
    [[nodiscard]] GLuint depthSampler() const { return depthSampler_.name(); }
    [[nodiscard]] const ShadowLookup& lookup() const { return lookup_; }

private:
    void fitLightFrustum(const std::vector<Drawable>& drawables, const Vec3& toLight, std::span<const Mat4> views);
    [[nodiscard]] PixelRectangle texelsOf(const Box3& inClip) const;
    [[nodiscard]] PixelRectangle changedTexels(const std::vector<Drawable>& drawables) const;
    void drawStatic(const std::vector<Drawable>& drawables, const PixelRectangle& part) const;
    void draw(const std::vector<Drawable>& drawables, bool tools, const PixelRectangle& part) const;

    ShaderProgram program_;
    gl::Texture staticMap_;
    gl::Texture combinedMap_;
    gl::Sampler depthSampler_;
    gl::Framebuffer staticFramebuffer_;
    gl::Framebuffer combinedFramebuffer_;
    Mat4 worldToClip_ = Mat4::Identity();
    Vec3 toLight_ = Vec3::UnitZ();
    ShadowLookup lookup_;
    std::vector<Mat4> staticPoses_;
    Mat4 staticWorldToClip_ = Mat4::Zero();
    Eigen::Vector4d section_ = Eigen::Vector4d(0, 0, 0, 1);
    double lodTolerance_ = 0;
};

}  // namespace tactooth
