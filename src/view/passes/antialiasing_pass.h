// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "view/gl/render_target.h"
#include "view/passes/edge_smoothing.h"

namespace tactooth {

/// Smooths the stair steps of edges in a finished picture of one sample a pixel. The processor does it: where it draws
/// the picture, too, this takes a tenth of the time of a shader.
class AntialiasingPass {
public:
    /// Changes the pixels of `target` at edges, and no others. Its depth stays. Waits until the picture is drawn.
    void apply(const RenderTarget& target);

private:
    std::vector<Rgba> pixels_;
};

}  // namespace tactooth
