// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/gl/drawable.h"
#include "view/gl/field_textures.h"
#include "view/gl/render_target.h"
#include "view/gl/shader_program.h"
#include "view/passes/frame_block.h"
#include "view/passes/shadow_map.h"
#include "view/scene/render_settings.h"

namespace tactooth {

/// The inputs for one drawing of the scene.
struct SolidInputs {
    const std::vector<Drawable>& drawables;
    const std::vector<Drawable>& capped;  ///< ShapeCache::Result::filled
    const std::vector<Drawable>& ghosts;
    const PassView& view;
    ImageSize size;  ///< of the whole picture
    FrameBlock frame;
    Mat4 cullMatrix;      ///< covers at most the view of the pass; clusters outside it are skipped
    double lodTolerance;  ///< mm for each mm of distance from the eye
    Shadows shadows;
    const ShadowMap& shadowMap;
    const FieldTextures& fields;
    const RenderTarget* shell = nullptr;  ///< depth of the body in this view, for inner objects and ghosts
    PixelRectangle glass = {};            ///< where bodies may turn to glass (glassPixels)
};

/// The pixels in which glass hides what `frame` keeps in sight; empty if it keeps nothing.
[[nodiscard]] PixelRectangle glassPixels(const FrameBlock& frame, ImageSize size);

/// Whether a part of `drawable` may turn to glass in this view.
[[nodiscard]] bool mayTurnToGlass(const SolidInputs& inputs, const Drawable& drawable);

/// The stencil bit that drawOpaque sets, if there are ghosts, where a sectioned object is visible.
inline constexpr GLint kStencilSeenThrough = 4;

/// Whether any of them is an inner object.
[[nodiscard]] bool showsLayers(const std::vector<Drawable>& drawables);

/// Makes the culler that selects the visible clusters of a drawable for these inputs, and their level of detail.
[[nodiscard]] ClusterCuller cullerFor(const SolidInputs& inputs, const Drawable& drawable, bool skipBackFaces,
                                      double lodTolerance);

/// Whether one sees into the solid part of `drawable` where the rest has turned to glass, as into the head of a bur:
/// then its back faces are drawn.
[[nodiscard]] bool isOpenedByGlass(const SolidInputs& inputs, const Drawable& drawable);

/// Draws the background, the lit objects, the section caps and the transparent objects into the bound framebuffer.
class SolidPass {
public:
    [[nodiscard]] static Expected<SolidPass> create();

    /// Draws the background and all opaque objects.
    void drawOpaque(const SolidInputs& inputs) const;
    /// Draws the transparent objects over the opaque part.
    void drawTransparent(const SolidInputs& inputs) const;
    /// Draws what has turned to glass over all else. It leaves no depth: what comes later treats it as air.
    void drawGlass(const SolidInputs& inputs) const;
    /// Draws only the depth of the first sectioned object, into `into`.
    void drawShell(const SolidInputs& inputs, const RenderTarget& into) const;

private:
    struct Variant {
        ShaderProgram plain;              ///< opaque, in the colours of the appearances
        ShaderProgram wet;                ///< the same under liquids
        ShaderProgram tissue, wetTissue;  ///< the same pictures where no appearance is metal, sooner
        ShaderProgram rich;               ///< transparent, inner, coloured by distance
        ShaderProgram machined;           ///< a handpiece, which may turn to glass
        ShaderProgram section;
    };
    void prepare(const SolidInputs& inputs) const;
    void drawBackground() const;
    static void beginStencil();
    static void endStencil();
    /// The part of a drawable that turns to glass is drawn apart from the rest.
    enum class Part { Solid, Glass };
    void drawObject(const SolidInputs& inputs, const Drawable& drawable, Part part = Part::Solid) const;
    void drawBlended(const SolidInputs& inputs, const Drawable& drawable) const;
    void setRichUniforms(const ShaderProgram& program, const SolidInputs& inputs, const Drawable& drawable,
                         Part part) const;
    void drawSectionCaps(const SolidInputs& inputs) const;
    void stencilInside(const SolidInputs& inputs, const Drawable& drawable, GLuint bit) const;
    void drawCap(const SolidInputs& inputs, const Box3& around, const Appearance& appearance) const;

    std::array<Variant, 4> variants_;  ///< by Shadows
    ShaderProgram background_;
    ShaderProgram depth_;
    gl::Texture noiseTexture_;
    gl::Buffer frameBuffer_;
    gl::VertexArray noVertices_;
};

}  // namespace tactooth
