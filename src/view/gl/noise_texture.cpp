// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/gl/noise_texture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <vector>

#include "geometry/util/parallel_for.h"

namespace tactooth {

namespace {

constexpr int kSide = 32;       ///< texels per side, a power of two
constexpr unsigned kSeed = 20;  ///< any number; a fixed seed makes pictures repeatable
constexpr std::size_t kTexels = std::size_t{kSide} * kSide * kSide;

using Volume = std::vector<float>;

/// Smooths along the axis whose neighbours are `step` texels apart, over the ends of the tile.
Volume smoothedAlong(const Volume& values, int step, const std::vector<float>& weights) {
    Volume sums(kTexels);
    const int reach = static_cast<int>(weights.size()) - 1;
    parallelFor(kTexels, [&](std::size_t i) {
        const int along = (static_cast<int>(i) / step) % kSide;
        const int start = static_cast<int>(i) - along * step;
        float sum = 0;
        for (int k = -reach; k <= reach; ++k) {
            const int place = (along + k) & (kSide - 1);
            sum +=
                weights[static_cast<std::size_t>(std::abs(k))] * values[static_cast<std::size_t>(start + place * step)];
        }
        sums[i] = sum;
    });
    return sums;
}

/// White noise smoothed by a Gaussian of `sigma` texels, with mean 0 and standard deviation 1. It looks the same in all
/// directions: noise between grid points would show its grid as a weave.
Volume smoothNoise(std::mt19937& random, float sigma) {
    Volume noise(kTexels);
    for (float& value : noise) value = static_cast<float>(random() % 65536) / 65535.0F - 0.5F;
    std::vector<float> weights;
    for (int k = 0; static_cast<float>(k) <= 3 * sigma; ++k) {
        weights.push_back(std::exp(-0.5F * static_cast<float>(k * k) / (sigma * sigma)));
    }
    for (const int step : {1, kSide, kSide * kSide}) noise = smoothedAlong(noise, step, weights);
    double squares = 0;
    for (const float value : noise) squares += static_cast<double>(value * value);
    const auto scale = static_cast<float>(1 / std::sqrt(squares / static_cast<double>(kTexels)));
    for (float& value : noise) value *= scale;
    return noise;
}

}  // namespace

gl::Texture makeNoiseTexture() {
    std::mt19937 random(kSeed);
    constexpr float kFine = 0.9F, kCoarse = 2.6F;              // texels
    constexpr float kFineShare = 0.12F, kCoarseShare = 0.15F;  // standard deviations in the texture, 0..1
    std::vector<std::array<std::uint8_t, 4>> texels(kTexels);
    for (std::size_t channel = 0; channel < 4; ++channel) {
        const Volume fine = smoothNoise(random, kFine), coarse = smoothNoise(random, kCoarse);
        for (std::size_t i = 0; i < kTexels; ++i) {
            const float value = 0.5F + kFineShare * fine[i] + kCoarseShare * coarse[i];
            texels[i][channel] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0F, 1.0F)));
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
