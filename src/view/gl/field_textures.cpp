// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/gl/field_textures.h"

#include <algorithm>

#include "view/scene/appearance.h"

namespace tactooth {

namespace {

constexpr int kColours = 256;  ///< texels: one for each level of an 8-bit channel

gl::Texture textureOf(const DistanceGrid& grid) {
    gl::Texture texture = gl::Texture::make();
    glBindTexture(GL_TEXTURE_3D, texture.name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_R32F, grid.counts.x(), grid.counts.y(), grid.counts.z(), 0, GL_RED, GL_FLOAT,
                 grid.values.data());
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAX_LEVEL, 0);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
        glTexParameteri(GL_TEXTURE_3D, filter, GL_LINEAR);
    }
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
        glTexParameteri(GL_TEXTURE_3D, axis, GL_CLAMP_TO_EDGE);
    }
    return texture;
}

gl::Texture colourTexture() {
    std::vector<Vec3f> row;
    for (int i = 0; i < kColours; ++i) row.push_back(linearColour(distanceColour(2.0 * i / (kColours - 1) - 1)));
    gl::Texture texture = gl::Texture::make();
    gl::allocateTexture(texture, GL_RGB16F, kColours, 1, GL_LINEAR);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kColours, 1, GL_RGB, GL_FLOAT, row.data());
    return texture;
}

}  // namespace

void FieldTextures::update(const std::vector<Drawable>& drawables) {
    std::vector<Entry> kept;
    for (const Drawable& drawable : drawables) {
        if (!drawable.object->distances) continue;
        const auto& grid = drawable.object->distances->grid;
        const auto holds = [&](const Entry& entry) { return entry.grid == grid; };
        if (std::any_of(kept.begin(), kept.end(), holds)) continue;
        const auto known = std::find_if(entries_.begin(), entries_.end(), holds);
        kept.push_back(known != entries_.end() ? std::move(*known) : Entry{grid, textureOf(*grid)});
    }
    entries_ = std::move(kept);
    if (!entries_.empty() && !colours_) colours_ = colourTexture();
}

GLuint FieldTextures::of(const DistanceGrid* grid) const {
    const auto known =
        std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.grid.get() == grid; });
    return known != entries_.end() ? known->texture.name() : 0;
}

Mat4 objectToField(const DistanceGrid& grid) {
    Mat4 matrix = Mat4::Identity();
    for (int axis = 0; axis < 3; ++axis) {
        const double scale = 1 / (grid.spacing * grid.counts[axis]);
        matrix(axis, axis) = scale;
        matrix(axis, 3) = 0.5 / grid.counts[axis] - grid.low[axis] * scale;  // samples are at the centres of the texels
    }
    return matrix;
}

}  // namespace tactooth
