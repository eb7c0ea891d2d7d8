// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/passes/solid_pass.h"

namespace tactooth {

/// The pixels that ghosts can cover; empty if there are no ghosts, or none in the picture.
[[nodiscard]] PixelRectangle ghostPixels(const std::vector<Drawable>& ghosts, const PassView& view, ImageSize size);

/// Draws the ghosts of a scene. A ghost is visible through sectioned objects, but not through instruments in front of
/// it.
///
/// Two layers of each ghost are drawn, as if it were of glass. The far layer is the nearest of the faces that point
/// toward the eye. Over it lies the nearest of the faces that point away: these are the sides of the cavity whose wall
/// is the ghost.
class GhostPass {
public:
    [[nodiscard]] static Expected<GhostPass> create();

    /// Draws only the ghosts of `inputs`, into `into`. Needs the shell.
    void draw(const SolidInputs& inputs, const RenderTarget& into) const;
    /// Composes the result of `draw` over the opaque part of the scene (SolidPass::drawOpaque), in the bound
    /// framebuffer.
    void compose(const RenderTarget& drawn) const;

private:
    void drawLayer(const SolidInputs& inputs, const Drawable& drawable, GLenum culled, float cover) const;

    ShaderProgram body_;
    ShaderProgram compose_;
    gl::Buffer frameBuffer_;
    gl::VertexArray noVertices_;
};

}  // namespace tactooth
