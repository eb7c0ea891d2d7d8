// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/gl/noise_texture.h"

#include <array>
#include <cstdint>
#include <random>
#include <vector>

namespace tactooth {

namespace {

constexpr int kSide = 32;       ///< texels per side
constexpr int kCoarseSide = 8;  ///< of the coarser of the two octaves
constexpr unsigned kSeed = 20;  ///< any number; a fixed seed makes pictures repeatable

/// Periodic random values on a coarse grid, interpolated linearly between the grid points.
class ValueNoise {
public:
    explicit ValueNoise(std::mt19937& random) {
        for (float& value : values_) value = static_cast<float>(random() % 256) / 255.0F;
    }
    [[nodiscard]] float at(int x, int y, int z) const {
        constexpr int kStep = kSide / kCoarseSide;
        float sum = 0;
        for (int corner = 0; corner < 8; ++corner) {
            const std::array<int, 3> offset = {corner & 1, (corner >> 1) & 1, corner >> 2};
            const std::array<int, 3> place = {x, y, z};
            float weight = 1;
            std::size_t index = 0;
            for (std::size_t axis = 3; axis-- > 0;) {
                const float part = static_cast<float>(place[axis] % kStep) / kStep;
                weight *= offset[axis] == 1 ? part : 1 - part;
                index =
                    index * kCoarseSide + static_cast<std::size_t>((place[axis] / kStep + offset[axis]) % kCoarseSide);
            }
            sum += weight * values_[index];
        }
        return sum;
    }

private:
    std::array<float, kCoarseSide * kCoarseSide * kCoarseSide> values_{};
};

}  // namespace

gl::Texture makeNoiseTexture() {
    std::mt19937 random(kSeed);
    const std::array<ValueNoise, 4> coarse = {ValueNoise(random), ValueNoise(random), ValueNoise(random),
                                              ValueNoise(random)};
    std::vector<std::array<std::uint8_t, 4>> texels;
    texels.reserve(kSide * kSide * kSide);
    for (int z = 0; z < kSide; ++z) {
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) {
                std::array<std::uint8_t, 4> texel{};
                for (std::size_t channel = 0; channel < 4; ++channel) {
                    const float fine = static_cast<float>(random() % 256);
                    texel[channel] =
                        static_cast<std::uint8_t>(0.25F * fine + 0.75F * 255.0F * coarse[channel].at(x, y, z));
                }
                texels.push_back(texel);
            }
        }
    }
    gl::Texture texture = gl::Texture::make();
    glBindTexture(GL_TEXTURE_3D, texture.name());
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, kSide, kSide, kSide, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    return texture;
}

}  // namespace tactooth
