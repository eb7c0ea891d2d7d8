// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/gl/drawable.h"
#include "view/gl/render_target.h"
#include "view/gl/shader_program.h"
#include "view/passes/frame_block.h"

namespace tactooth {

/// The depth picture seen from the operating light. What stands still is drawn only when it or the light changes, and
/// where it changes; a copy of it receives the tools of each picture.
class ShadowMap {
public:
    [[nodiscard]] static Expected<ShadowMap> create();

    /// `section`: what lies on the negative side of this plane throws no shadow, if it is of a sectioned object.
    /// `lodTolerance`: as RenderSettings::lodTolerance, of the map's texels and twice that.
    /// `staticShapesRemoved`: a shape that does not move was in the picture before and is not among `drawables`.
    void update(const std::vector<Drawable>& drawables, bool staticShapesRemoved, const Vec3& toLight,
                const Eigen::Vector4d& section, double lodTolerance);
    /// To be called for a picture without `update`: the next one draws all anew.
    void invalidate() { staticWorldToClip_.setZero(); }
    [[nodiscard]] GLuint texture() const { return combinedMap_.name(); }
    [[nodiscard]] const ShadowLookup& lookup() const { return lookup_; }

private:
    void fitLightFrustum(const std::vector<Drawable>& drawables, const Vec3& toLight);
    [[nodiscard]] PixelRectangle texelsOf(const Box3& inClip) const;
    [[nodiscard]] PixelRectangle changedTexels(const std::vector<Drawable>& drawables) const;
    void drawStatic(const std::vector<Drawable>& drawables, const PixelRectangle& part) const;
    void draw(const std::vector<Drawable>& drawables, bool tools, const PixelRectangle& part) const;

    ShaderProgram program_;
    gl::Texture staticMap_;
    gl::Texture combinedMap_;
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
