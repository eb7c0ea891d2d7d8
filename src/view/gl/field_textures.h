// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "view/gl/drawable.h"

namespace tactooth {

/// The distance grids of the last scene and their colour table, as textures.
class FieldTextures {
public:
    /// Uploads the new grids of `drawables` and drops grids that they no longer use.
    void update(const std::vector<Drawable>& drawables);
    /// 0 if no drawable of the last update has `grid`.
    [[nodiscard]] GLuint of(const DistanceGrid* grid) const;
    /// One row with the colours of `distanceColour`, linear light.
    [[nodiscard]] GLuint colours() const { return colours_.name(); }

private:
    struct Entry {
        std::shared_ptr<const DistanceGrid> grid;
        gl::Texture texture;
    };
    std::vector<Entry> entries_;
    gl::Texture colours_;
};

/// Object coordinates to texture coordinates of `grid`.
[[nodiscard]] Mat4 objectToField(const DistanceGrid& grid);

}  // namespace tactooth
