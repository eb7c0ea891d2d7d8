// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/gl/drawable.h"
#include "view/passes/frame_block.h"
#include "view/gl/render_target.h"
#include "view/gl/shader_program.h"

namespace tactooth {

/// The depth picture seen from the operating light. What stands still is drawn only when it or the light changes, and
/// where it changes; a copy of it receives the tools of each picture.
class ShadowMap {
public:
    [[nodiscard]] static Expected<ShadowMap> create();

    /// `section`: what lies on the negative side of this plane throws no shadow, if it is of a sectioned object.
    /// `coarseness`: as RenderSettings::coarseness, of the map's texels and twice that.
    /// `stillShapesGone`: a shape that does not move was in the picture before and is not among `drawables`.
    void update(const std::vector<Drawable>& drawables, bool stillShapesGone, const Vec3& toLight,
                const Eigen::Vector4d& section, double coarseness);
    /// To be called for a picture without `update`: the next one draws all anew.
    void forget() { stillAim_.setZero(); }
    [[nodiscard]] GLuint texture() const { return withTools_.name(); }
    [[nodiscard]] const ShadowLookup& lookup() const { return lookup_; }

private:
    void aim(const std::vector<Drawable>& drawables, const Vec3& toLight);
    [[nodiscard]] PixelRectangle texelsOf(const Box3& inClip) const;
    [[nodiscard]] PixelRectangle changedTexels(const std::vector<Drawable>& drawables) const;
    void drawStill(const std::vector<Drawable>& drawables, const PixelRectangle& part) const;
    void draw(const std::vector<Drawable>& drawables, bool tools, const PixelRectangle& part) const;

    ShaderProgram program_;
    gl::Texture still_;
    gl::Texture withTools_;
    gl::Framebuffer stillFramebuffer_;
    gl::Framebuffer withToolsFramebuffer_;
    Mat4 worldToClip_ = Mat4::Identity();
    Vec3 toLight_ = Vec3::UnitZ();
    ShadowLookup lookup_;
    std::vector<Mat4> stillPoses_;
    Mat4 stillAim_ = Mat4::Zero();
    Eigen::Vector4d section_ = Eigen::Vector4d(0, 0, 0, 1);
    double coarseness_ = 0;
};

}  // namespace tactooth
