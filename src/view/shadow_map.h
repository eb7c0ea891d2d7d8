// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/drawable.h"
#include "view/frame_block.h"
#include "view/shader_program.h"

namespace tactooth {

/// The depth picture seen from the operating light. What stands still is drawn only when it or the light changes; a
/// copy of it receives the tools of each picture.
class ShadowMap {
public:
    [[nodiscard]] static Expected<ShadowMap> create();

    void update(const std::vector<Drawable>& drawables, bool stillShapesChanged, const Vec3& toLight);
    [[nodiscard]] GLuint texture() const { return withTools_.name(); }
    [[nodiscard]] const ShadowLookup& lookup() const { return lookup_; }

private:
    void aim(const std::vector<Drawable>& drawables, const Vec3& toLight);
    void draw(const std::vector<Drawable>& drawables, bool tools) const;

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
};

}  // namespace tactooth
