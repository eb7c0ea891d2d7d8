// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/passes/solid_pass.h"
#include "view/scene/object_ids.h"

namespace tactooth {

/// Draws id pictures (view/scene/object_ids.h).
class IdPass {
public:
    [[nodiscard]] static Expected<IdPass> create();

    /// Into the bound framebuffer, which has one sample for each pixel.
    void draw(const SolidInputs& inputs, const Scene& scene, const MarkedBall& ball) const;

private:
    void drawObject(const SolidInputs& inputs, const Scene& scene, const Drawable& drawable, int phase) const;

    ShaderProgram program_;
    gl::Buffer frameBuffer_;
};

}  // namespace tactooth
