// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/gl/render_target.h"
#include "view/passes/solid_pass.h"

namespace tactooth {

/// The pixels that `mirror` can cover; empty if it is seen from behind or is not visible.
[[nodiscard]] PixelRectangle coveredPixels(const SceneMirror& mirror, const Camera& camera, ImageSize size);

/// The view through the mirror: the world reflected in its plane, without anything behind the glass.
[[nodiscard]] PassView reflectedView(const PassView& direct, const Plane& mirror);

/// Draws the mirror's disc with the reflected picture (drawn in `covered`) into the bound framebuffer.
class MirrorPass {
public:
    [[nodiscard]] static Expected<MirrorPass> create();
    void draw(const SceneMirror& mirror, const FrameBlock& frame, const RenderTarget& reflection,
              const PixelRectangle& covered) const;

private:
    ShaderProgram program_;
    gl::Buffer frameBuffer_;
    gl::VertexArray noVertices_;
};

}  // namespace tactooth
