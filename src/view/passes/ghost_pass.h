// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/passes/solid_pass.h"

namespace tactooth {

/// The pixels that ghosts can cover; empty if there are none, or none in the picture.
[[nodiscard]] PixelRectangle ghostPixels(const std::vector<Drawable>& ghosts, const PassView& view, ImageSize size);

/// Draws the ghosts of a scene: bodies that are seen through what is sectioned, but not through the instruments in
/// front of it.
///
/// Two layers of each are shown, as of a body of glass: the nearest of the faces that look at the eye, and over them
/// the nearest of those that look away from it, which are the sides of the hollow that the ghost is the wall of.
class GhostPass {
public:
    [[nodiscard]] static Expected<GhostPass> create();

    /// The ghosts of `inputs` alone, into `into`. Needs the shell.
    void draw(const SolidInputs& inputs, const RenderTarget& into) const;
    /// Lays what was drawn over the opaque part of the scene (SolidPass::drawOpaque), in the framebuffer that is bound.
    void compose(const RenderTarget& drawn) const;

private:
    void drawLayer(const SolidInputs& inputs, const Drawable& drawable, GLenum culled, float cover) const;

    ShaderProgram body_;
    ShaderProgram compose_;
    gl::Buffer frameBuffer_;
    gl::VertexArray noVertices_;
};

}  // namespace tactooth
